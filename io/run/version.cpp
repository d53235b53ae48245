// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/version.hpp"

#include "io/run/git_commit.hpp"
#include <Eigen/Core>
#include <H5public.h>
#include <fmt/format.h>

namespace io {

std::string git_commit() { return built_commit; }

std::vector<std::pair<std::string, std::string>> library_versions()
{
    return {
        {"compiler", __VERSION__},
        {"Open MPI", ISAGO_MPI_VERSION},
        {"oneTBB", ISAGO_TBB_VERSION},
        {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"HDF5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE)},
        {"yaml-cpp", ISAGO_YAML_VERSION},
        {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
    };
}

std::string version_text()
{
    std::string text = fmt::format("isago {} ({})\n", ISAGO_VERSION, git_commit());
    for (const auto& [name, version] : library_versions()) text += fmt::format("  {:<14} {}\n", name, version);
    text.pop_back();
    return text;
}

} // namespace io

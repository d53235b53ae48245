// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/lone_process.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace core {
namespace {

bool is_started_with_others()
{
    constexpr std::array signs{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMIX_NAMESPACE", "PMI_RANK", "PMI_FD", "SLURM_PROCID"};
    return std::ranges::any_of(signs, [](const char* name) { return std::getenv(name) != nullptr; });
}

} // namespace

LoneProcess::LoneProcess()
{
    constexpr std::array choices{
        std::pair{"OMPI_MCA_pml", "ob1"},              // messages
        std::pair{"OMPI_MCA_btl", "self"},             // from this process to itself
        std::pair{"HWLOC_COMPONENTS", "-pci,-linuxio"} // no list of devices
    };
    if (is_started_with_others()) return;
    for (const auto& [name, value] : choices) {
        if (std::getenv(name)) continue;
        setenv(name, value, 0);
        said_.push_back(name);
    }
}

LoneProcess::~LoneProcess()
{
    for (const char* name : said_) unsetenv(name);
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/launch.hpp"

#include "core/base/error.hpp"
#include "io/manifest.hpp"
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace io {

Launch mpirun_launch(int ranks, const std::vector<std::string>& program, const LaunchSite& site)
{
    Launch launch{{"mpirun", "-n", std::to_string(ranks), "--bind-to", "none"}, {}};
    // Open MPI 4 reads the first names, Open MPI 5 the second.
    auto set_both = [&](const std::string& four, const std::string& five, const std::string& value) {
        launch.environment.emplace_back(four, value);
        launch.environment.emplace_back(five, value);
    };
    set_both("OMPI_MCA_odls_base_sigkill_timeout", "PRTE_MCA_odls_base_sigkill_timeout", "30");
    if (ranks > site.cores) {
        launch.environment.emplace_back("OMPI_MCA_rmaps_base_oversubscribe", "1");
        launch.environment.emplace_back("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe");
    }
    if (site.as_root) {
        set_both("OMPI_ALLOW_RUN_AS_ROOT", "PRTE_ALLOW_RUN_AS_ROOT", "1");
        set_both("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "PRTE_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    }
    launch.environment.emplace_back("OMP_PROC_BIND", "false");
    launch.command.insert(launch.command.end(), program.begin(), program.end());
    return launch;
}

std::vector<std::string> without_option(std::vector<std::string> words, const std::string& option)
{
    for (auto word = words.begin(); word != words.end();) {
        const bool alone = *word == option;
        if (!alone && !word->starts_with(option + "=")) {
            ++word;
            continue;
        }
        word = words.erase(word);
        if (alone && word != words.end()) word = words.erase(word);
    }
    return words;
}

std::optional<int> ranks_of_mpirun()
{
    const char* size = std::getenv("OMPI_COMM_WORLD_SIZE");
    if (size == nullptr) return {};
    int ranks = 0;
    std::from_chars(size, size + std::strlen(size), ranks);
    return ranks;
}

void start_ranks(int ranks, int argc, char** argv)
{
    if (const auto started = ranks_of_mpirun()) {
        return core::require<core::ConfigError>(
            *started == ranks, fmt::format("--ranks {} inside an mpirun of {} ranks; leave out one of the two", ranks,
                                           *started));
    }
    auto words = without_option({argv, argv + argc}, "--ranks");
    words.front() = std::filesystem::read_symlink("/proc/self/exe").string();
    const Launch launch = mpirun_launch(ranks, words, {available_cores(), geteuid() == 0});
    for (const auto& [name, value] : launch.environment) setenv(name.c_str(), value.c_str(), 0);
    std::vector<char*> arguments;
    for (const auto& word : launch.command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    throw core::ConfigError(fmt::format("mpirun cannot be started: {}; install Open MPI, or leave out --ranks",
                                        std::strerror(errno)));
}

} // namespace io

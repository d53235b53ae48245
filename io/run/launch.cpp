// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/launch.hpp"

#include "core/base/error.hpp"
#include "io/run/manifest.hpp"
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace io {

namespace {

constexpr int command_not_found = 127; // what a shell returns, too

/// In the child: a process group of its own, which Ctrl-C of the terminal does not reach.
[[noreturn]] void become_mpirun(const Launch& launch, const sigset_t& signals)
{
    if (isatty(STDOUT_FILENO) == 1) setenv(terminal_variable, "1", 1);
    for (const auto& [name, value] : launch.environment) setenv(name.c_str(), value.c_str(), 0);
    std::vector<char*> arguments;
    for (const auto& word : launch.command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    setpgid(0, 0);
    if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) dup2(nothing, STDIN_FILENO);
    sigprocmask(SIG_SETMASK, &signals, nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(command_not_found);
}

/// Passes signals on until the child has ended. @returns its exit code.
[[nodiscard]] int wait_for(pid_t child, const sigset_t& waited)
{
    bool asked = false;
    for (;;) {
        const int signal = sigwaitinfo(&waited, nullptr);
        int status = 0;
        if (waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        if (signal != SIGINT && signal != SIGTERM && signal != SIGUSR1) continue;
        kill(child, asked && signal != SIGUSR1 ? SIGTERM : signal_to_ranks(signal));
        asked = true;
    }
}

} // namespace

namespace {

constexpr const char* spin_variable = "GOMP_SPINCOUNT";

/// Turns of a loop of some 50 ns: none where threads are more than cores. More than 1000 gain nothing on idle cores, and
/// double the time on busy ones.
std::string openmp_spin(int threads_of_all_ranks, int cores) { return threads_of_all_ranks > cores ? "0" : "1000"; }

} // namespace

Launch mpirun_launch(int ranks, const std::vector<std::string>& program, const LaunchSite& site)
{
    Launch launch{{"mpirun", "-n", std::to_string(ranks), "--bind-to", "none"}, {}};
    // Open MPI 4 reads the first names, Open MPI 5 the second.
    auto set_both = [&](const std::string& four, const std::string& five, const std::string& value) {
        launch.environment.emplace_back(four, value);
        launch.environment.emplace_back(five, value);
    };
    if (ranks > site.cores) {
        launch.environment.emplace_back("OMPI_MCA_rmaps_base_oversubscribe", "1");
        launch.environment.emplace_back("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe");
    }
    if (site.as_root) {
        set_both("OMPI_ALLOW_RUN_AS_ROOT", "PRTE_ALLOW_RUN_AS_ROOT", "1");
        set_both("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "PRTE_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    }
    launch.environment.emplace_back("OMP_PROC_BIND", "false");
    if (std::getenv("OMP_WAIT_POLICY") == nullptr)
        launch.environment.emplace_back(spin_variable, openmp_spin(ranks * site.threads, site.cores));
    if (ranks * site.threads > site.cores) launch.environment.emplace_back("OMPI_MCA_mpi_yield_when_idle", "1");
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

std::optional<int> start_ranks(int ranks, int threads, int argc, char** argv)
{
    if (const auto started = ranks_of_mpirun()) {
        core::require<core::ConfigError>(*started == ranks,
                                         fmt::format("--ranks {} inside an mpirun of {} ranks; leave out one of the two", ranks, *started));
        return {};
    }
    auto words = without_option({argv, argv + argc}, "--ranks");
    words.front() = std::filesystem::read_symlink("/proc/self/exe").string();
    const Launch launch = mpirun_launch(ranks, words, {available_cores(), geteuid() == 0, threads});

    sigset_t waited, before;
    sigemptyset(&waited);
    for (int signal : {SIGINT, SIGTERM, SIGUSR1, SIGCHLD}) sigaddset(&waited, signal);
    sigprocmask(SIG_BLOCK, &waited, &before);
    const pid_t child = fork();
    core::require<core::Error>(child >= 0, fmt::format("mpirun cannot be started: {}", std::strerror(errno)));
    if (child == 0) become_mpirun(launch, before);
    const int code = wait_for(child, waited);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    core::require<core::ConfigError>(code != command_not_found, "mpirun cannot be started; install Open MPI, or leave out --ranks");
    return code;
}

void restrain_openmp(int threads, char** argv)
{
    if (threads == 1 || std::getenv(spin_variable) != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
    const char* on_this_node = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
    const int ranks = on_this_node == nullptr ? 1 : std::max(1, std::atoi(on_this_node));
    setenv(spin_variable, openmp_spin(ranks * threads, available_cores()).c_str(), 1);
    execv("/proc/self/exe", argv); // comes back only if it fails: then loops are slow where cores are short, no more
}

} // namespace io

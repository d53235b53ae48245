// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// `--ranks N`: the program starts itself under mpirun and passes on requests to stop. mpirun answers TERM and Ctrl-C by
// killing its ranks within seconds, but hands some other signals on to them: so each request goes to the ranks as one of
// those, and a last checkpoint has the time that it needs.
#include <csignal>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace io {

struct Launch {
    std::vector<std::string> command;
    std::vector<std::pair<std::string, std::string>> environment; ///< Added unless the user has set them.
};

/// Where ranks are started.
struct LaunchSite {
    int cores = 1;
    bool as_root = false;
    int threads = 1; ///< of each rank
};

/// mpirun without binding (a bound rank would have one core for all its threads), with more ranks than cores only where
/// needed, and as root only for root. Where threads outnumber cores, nobody spins.
/// @param program  The program and its arguments.
[[nodiscard]] Launch mpirun_launch(int ranks, const std::vector<std::string>& program, const LaunchSite& site);

/// The words without an option and its value, in both forms: "--ranks 2" and "--ranks=2".
[[nodiscard]] std::vector<std::string> without_option(std::vector<std::string> words, const std::string& option);

/// The number of ranks if mpirun started this process, or nothing.
[[nodiscard]] std::optional<int> ranks_of_mpirun();

/// Set for the ranks if the standard output is a terminal: they write into a pipe of mpirun and cannot see it.
inline constexpr const char* terminal_variable = "ISAGO_TERMINAL";

/// What mpirun hands on for Ctrl-C and TERM; all others go as they are.
inline constexpr int signal_for_interrupt = SIGALRM, signal_for_terminate = SIGUSR2;
[[nodiscard]] constexpr int signal_to_ranks(int signal)
{
    return signal == SIGINT ? signal_for_interrupt : signal == SIGTERM ? signal_for_terminate : signal;
}

/// Runs the same command on `ranks` ranks of so many threads and waits for its end; Ctrl-C, TERM and USR1 reach all ranks as
/// requests to stop, a second Ctrl-C or TERM ends them at once.
/// @returns the exit code, or nothing if this process is one of the ranks.
/// @throws core::ConfigError if mpirun started another number of ranks, or cannot be found.
[[nodiscard]] std::optional<int> start_ranks(int ranks, int threads, int argc, char** argv);

/// By itself a thread of an OpenMP team spins for 15 ms at the end of each loop before it sleeps; where cores are short, each
/// loop takes that long. The library reads its settings when it is loaded: this sets them, unless the user has, and starts
/// the program again, once. To be called before MPI begins. @param threads  of this rank
void restrain_openmp(int threads, char** argv);

} // namespace io

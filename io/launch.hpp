// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// `--ranks N`: the program starts itself under mpirun and passes on requests to stop. mpirun answers TERM and Ctrl-C by
// killing its ranks within seconds, but hands USR1 on to them: so every request becomes a USR1, and a last checkpoint has
// the time that it needs.
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
};

/// mpirun without binding (a bound rank would have one core for all its threads), with more ranks than cores only where
/// needed, and as root only for root.
/// @param program  The program and its arguments.
[[nodiscard]] Launch mpirun_launch(int ranks, const std::vector<std::string>& program, const LaunchSite& site);

/// The words without an option and its value, in both forms: "--ranks 2" and "--ranks=2".
[[nodiscard]] std::vector<std::string> without_option(std::vector<std::string> words, const std::string& option);

/// The number of ranks if mpirun started this process, or nothing.
[[nodiscard]] std::optional<int> ranks_of_mpirun();

/// Set for the ranks if the standard output is a terminal: they write into a pipe of mpirun and cannot see it.
inline constexpr const char* terminal_variable = "ISAGO_TERMINAL";

/// Runs the same command on `ranks` ranks and waits for its end; Ctrl-C, TERM and USR1 become one USR1 for all ranks, a
/// second Ctrl-C or TERM ends them at once.
/// @returns the exit code, or nothing if this process is one of the ranks.
/// @throws core::ConfigError if mpirun started another number of ranks, or cannot be found.
[[nodiscard]] std::optional<int> start_ranks(int ranks, int argc, char** argv);

} // namespace io

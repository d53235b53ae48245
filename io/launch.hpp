// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// `--ranks N`: the program starts itself under mpirun, with settings that let threads and last checkpoints work.
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

/// mpirun without binding (a bound rank would have one core for all its threads), with 30 s from a signal to the kill (a
/// checkpoint takes some), with more ranks than cores only where needed, and as root only for root.
/// @param program  The program and its arguments.
[[nodiscard]] Launch mpirun_launch(int ranks, const std::vector<std::string>& program, const LaunchSite& site);

/// The words without an option and its value, in both forms: "--ranks 2" and "--ranks=2".
[[nodiscard]] std::vector<std::string> without_option(std::vector<std::string> words, const std::string& option);

/// The number of ranks if mpirun started this process, or nothing.
[[nodiscard]] std::optional<int> ranks_of_mpirun();

/// Replaces this process by `ranks` ranks of the same command; returns if there is nothing to start, because mpirun has
/// already started this number.
/// @throws core::ConfigError if mpirun started another number, or cannot be found.
void start_ranks(int ranks, int argc, char** argv);

} // namespace io

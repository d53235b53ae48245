// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The options of every command that computes: ranks, threads, executor.
#include "io/cli/command.hpp"

namespace io {

struct ParallelOptions {
    std::optional<int> ranks, threads;
    std::string executor = "auto";
};

/// --ranks, --threads and --executor, bound to `place`.
[[nodiscard]] std::vector<Option> parallel_options(ParallelOptions& place);

/// Checks the options and runs the command on the ranks asked for: to be called before MPI begins.
/// @returns the exit code of the ranks that were started, or nothing in a process that is to do the work itself.
/// @throws core::ConfigError for numbers below one or an executor that does not exist.
[[nodiscard]] std::optional<int> begin_parallel(const ParallelOptions& options, const Invocation& invocation);

/// The threads of each rank: as asked for, or an equal share of the cores.
[[nodiscard]] int chosen_threads(const ParallelOptions& options, int ranks);

} // namespace io

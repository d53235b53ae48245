// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a run directory says about how it came to be: versions, machine, command.
#include <string>
#include <vector>

namespace io {

struct RunFacts {
    std::vector<std::string> command; ///< The words of the command line.
    int ranks = 1, threads = 1;
    std::string executor;
};

/// JSON: program and library versions, commit, machine, cores, start in UTC, command, ranks, threads, executor.
[[nodiscard]] std::string manifest_text(const RunFacts& facts);

/// The cores that this process may use.
[[nodiscard]] int available_cores();

} // namespace io

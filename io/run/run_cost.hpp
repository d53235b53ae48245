// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a run has taken of the machine, in words: memory, and from a trace the work of lanes and what hides what.
#include "io/run/world.hpp"
#include "tasks/trace.hpp"

namespace io {

/// Resident memory of this process at its greatest [bytes].
[[nodiscard]] std::size_t greatest_memory();

/// Memory of all ranks, per cell, and of the grains, per grain. Collective.
[[nodiscard]] std::string memory_line(const World& world);

/// One line for each rank. Collective.
[[nodiscard]] std::vector<std::string> trace_lines(const tasks::Digest& digest, const core::Communicator& ranks);

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sides that lie on each other without matching points.
#include "core/grid/topology.hpp"

namespace core {

struct TouchingSides : SideContact {
    double share = 0; ///< of the smaller side that lies on the other
};

/// All pairs of boundary sides, in the domain or through a period, whose faces lie on each other with their blocks on opposite
/// sides, though they did not match point by point.
[[nodiscard]] std::vector<TouchingSides> touching_sides(const MultiBlock& grid, const Topology& topology);

/// Checks what the turn of a grid lays on each other; nothing without one.
/// @throws ConfigError if it joins no sides, or lays sides on each other whose points do not match.
void require_turn_joins(const MultiBlock& grid, const Topology& topology);

} // namespace core

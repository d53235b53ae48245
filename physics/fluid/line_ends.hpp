// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lines of a block as parts of chains: each is solved by itself, then moved to the values that the chain finds at its ends.
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

/// How firmly the lines of a block hold to what lies beyond their ends.
[[nodiscard]] std::array<double, 2> line_hold(const MultigridLevel& level, core::LocalBlock b, LineAxis axis);

/// What the chains need of the lines of a block, and how values at the ends of a line spread along it.
/// @pre level.inverse holds the sums of the coefficients across the lines, not yet pivots.
void form_ports(MultigridLevel& level, core::LocalBlock b);
/// Currents into the ends of the lines, from lines solved with zero beyond their ends.
/// @pre level.residual holds the solved lines.
void gather_ends(MultigridLevel& level, core::LocalBlock b);
/// Turns the solved lines of a block, in level.residual, into their parts of the solved chains.
void move_to_ends(MultigridLevel& level, core::LocalBlock b);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Corrections come up by linear interpolation along conductors in series, residuals go down by its transpose.
#include "core/base/team.hpp"
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

/// Residual of `solution`.
void compute_residual(const core::Team& team, MultigridLevel& level);

/// First part of the restriction: coarse.right = sums of fine.residual over the children; the parts that go to the
/// neighbours of the parent, in coarse.side_part and coarse.half_part.
void gather_children(const core::Team& team, const MultigridLevel& fine, MultigridLevel& coarse);
/// Second part: coarse.right of every cell gives its parts and takes those of its neighbours in the block.
void share_inside(const core::Team& team, MultigridLevel& coarse);
/// Third part: the same over links.
/// @pre half_received holds what partners on other ranks give.
void share_over_links(const core::Team& team, MultigridLevel& coarse);

/// fine.solution += interpolated coarse.solution. A child takes its parent's value and, towards each of the three nearest
/// neighbours of the parent, the share of the difference that lies between parent and child: a quarter in a uniform
/// medium.
/// @pre Ghosts of coarse.solution are up to date.
void prolong_correction(const core::Team& team, const MultigridLevel& coarse, MultigridLevel& fine);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Residuals go down as sums, corrections come up by linear interpolation.
#include "core/base/team.hpp"
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

/// Residual of `solution`.
void compute_residual(const core::Team& team, MultigridLevel& level);
/// coarse.right = sums of fine.residual over the children, for blocks with a finer block here.
void restrict_residual(const core::Team& team, const MultigridLevel& fine, MultigridLevel& coarse);
/// fine.solution += interpolated coarse.solution: a quarter of the parent and of each of its three nearest neighbours;
/// beyond a side the neighbour is the mean over the links, weighted with their transmissibilities.
/// @pre Ghosts of coarse.solution are up to date.
void prolong_correction(const core::Team& team, const MultigridLevel& coarse, MultigridLevel& fine);

} // namespace physics

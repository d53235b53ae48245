// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Coefficients of a coarse level: conductors of the finer level in series and in parallel. No matrix product.
#include "core/base/team.hpp"
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

/// Half of the resistance between the two children of the coarse cell at either end of each link of `fine`.
void link_end_resistances(const core::Team& team, MultigridLevel& fine);
/// Coefficients and transfer weights of all blocks that have a finer block on this rank.
void coarsen_coefficients(const core::Team& team, const MultigridLevel& fine, MultigridLevel& coarse);
/// Coefficients of the links that come from links of `fine`, and the sums of which their transfer weights are made.
/// @pre link_end_resistances(fine); ends on other ranks have been received.
void coarsen_links(const MultigridLevel& fine, MultigridLevel& coarse);
/// Half links and transfer weights from the coefficients of all links.
void finish_links(MultigridLevel& coarse);
/// Copies the transmissibility of each link to its half links.
void spread_links(MultigridLevel& level);

} // namespace physics

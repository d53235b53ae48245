// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How fast what goes through a cell would fill it: what limits explicit steps.
#include "core/grid/mesh.hpp"
#include "tasks/job.hpp"
#include "tasks/lane.hpp"

namespace physics {

/// Largest of through / (share * volume) over the cells of all ranks.
/// @param through  Volume per time of each cell [m3/s].
/// @param share    Part of each cell that can be filled [-].
/// @param[out] rate  [1/s]
tasks::Job find_largest_rate(tasks::Lane& lane, const core::Mesh& mesh, const core::ScalarField& through, const core::ScalarField& share,
                             double& rate);
/// The same where all of each cell can be filled.
tasks::Job find_largest_rate(tasks::Lane& lane, const core::Mesh& mesh, const core::ScalarField& through, double& rate);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The coupling filter on many ranks.
#include "core/grid/mesh.hpp"
#include "physics/coupling/filter.hpp"
#include "tasks/lane.hpp"

namespace physics {

/// Loads the geometry and chooses the polynomial for the thinnest cells of all ranks.
tasks::Job set_up(tasks::Lane& lane, Filter& filter, Coefficients transmissibility, const core::ScalarField& volume);

/// The same for the blocks of a mesh that `rank` has.
tasks::Job set_up_on_mesh(tasks::Lane& lane, Filter& filter, const core::Mesh& mesh, int rank);

/// Filters the first `fields` of the batch.
tasks::Job run(tasks::Lane& lane, Filter& filter, int fields);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The part of turbulent friction that the Laplacian leaves out: div((nu' - nu) ((grad u)^T - div u)), with nu' that varies in space. For a
// viscosity that does not vary it vanishes. div u, zero where the flow keeps its volume and beside grains a part of the pressure, is taken
// off because this part of the stress is explicit: without it the velocity across thin layers would feel its own second difference across
// them, as much of it as the Laplacian has and in steps of any length; what is left has a derivative along the layer in each term.
#include "physics/fluid/boundary.hpp"

namespace physics {

/// What it follows from.
struct TransposedStress {
    const core::BlockGeometry& geometry;
    const BlockWalls& walls;
    double viscosity;                                        ///< nu [m2/s]
    std::array<core::VectorView<const double>, 3> gradients; ///< of the components of velocity, one halo layer [1/s]
    core::FaceView<const double> ratio;                      ///< nu' / nu
};

/// out += time * acceleration. On boundaries it is zero: along walls nothing changes, and the layer at a wall has its friction whole.
/// @param scratch  Overwritten.
void add_transposed_stress(const TransposedStress& stress, double time, core::FaceView<double> scratch, core::VectorView<double> out);

} // namespace physics

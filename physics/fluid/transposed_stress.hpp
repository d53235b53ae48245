// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The part of turbulent friction that the Laplacian leaves out: div((nu' - nu) (grad u)^T), with nu' that varies in space. For a
// viscosity that does not vary it vanishes, as the flow keeps its volume.
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

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene says about its fluid.
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/drive.hpp"

namespace physics {

/// How exactly the linear systems of a step are solved.
struct FluidTolerances {
    double pressure = 1e-6;         ///< net volume flux of a cell over the flux through it, root mean square
    double viscosity = 1e-8;        ///< residual over the viscous change of velocity
    int most_iterations = 200;
};

struct FluidParameters {
    double density = 1000;            ///< [kg/m3]
    double viscosity = 1e-6;          ///< kinematic [m2/s]; 0 leaves all viscous stages out
    Drive drive = ConstantDrive{};
    WallVelocities walls;
    FluidTolerances tolerances;
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene says about its fluid.
#include "physics/fluid/advection_scheme.hpp"
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/drive.hpp"
#include <algorithm>

namespace physics {

/// How exactly the linear systems of a step are solved.
struct FluidTolerances {
    double pressure = 1e-6;        ///< net volume flux of a cell over the flux through it, root mean square
    double pressure_change = 1e-2; ///< net volume flux of a cell over that before the projection: keeps small steps accurate
    double viscosity = 1e-8;       ///< residual over the viscous change of velocity
    int most_iterations = 200;

    /// What the pressure solver may leave of the net outflow; both as 2-norms over the cells [m3/s].
    /// @param share  Of the tolerance `pressure`, for one of several steps whose remains add up.
    [[nodiscard]] double pressure_target(double throughput, double outflow, double share) const
    {
        constexpr double round_off = 1e-14;
        return std::max(round_off * throughput, std::min(share * pressure * throughput, pressure_change * outflow));
    }
};

struct FluidParameters {
    double density = 1000;   ///< [kg/m3]
    double viscosity = 1e-6; ///< kinematic [m2/s]; 0 leaves all viscous stages out
    Drive drive = ConstantDrive{};
    BoundaryConditions boundaries;
    AdvectionScheme advection = AdvectionScheme::lcsi;
    FluidTolerances tolerances;
};

} // namespace physics

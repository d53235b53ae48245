// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Drag law of Tenneti, Garg and Subramaniam.
#include "physics/coupling/drag.hpp"

namespace physics {

/// Fit to resolved flow through fixed random arrays of spheres, for C = 1 - phi from 0.1 to 0.5 and Re = rho phi |u-v| d / mu to
/// 300 [kg/s]. The whole force, mean pressure gradient included, is 3 pi mu d phi (u-v) F; phi times that is drag beside the
/// pressure-gradient force (set II).
/// F = (1 + 0.15 Re^0.687) / phi^3 + 5.81 C / phi^3 + 0.48 C^(1/3) / phi^4 + C^3 Re (0.95 + 0.61 C^3 / phi^2).
/// @source  Tenneti, Garg, Subramaniam (2011), International Journal of Multiphase Flow 37, 1072.
[[nodiscard]] inline double drag_tenneti(const DragInput& in)
{
    const double phi = std::max(in.phi, smallest_closure_fraction), solid = 1.0 - phi;
    const double reynolds = in.density * phi * in.slip * in.diameter / in.viscosity;
    const double cube = phi * phi * phi, solid_cube = solid * solid * solid;
    const double whole = (drag_over_stokes(reynolds) + 5.81 * solid) / cube + 0.48 * std::cbrt(solid) / (cube * phi) +
                         solid_cube * reynolds * (0.95 + 0.61 * solid_cube / (phi * phi));
    return 3.0 * std::numbers::pi * in.viscosity * in.diameter * phi * phi * whole;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Drag law of Beetstra, van der Hoef and Kuipers.
#include "physics/coupling/drag.hpp"

namespace physics {

/// Fit to resolved flow through random arrays of spheres, for phi from 0.4 and Re = rho phi |u-v| d / mu to 1000 [kg/s].
/// Force = 3 pi mu d phi (u-v) F beside the pressure-gradient force (set II), C = 1 - phi:
/// F = 10 C / phi^2 + phi^2 (1 + 1.5 sqrt C)
///   + 0.413 Re / (24 phi^2) (1/phi + 3 phi C + 8.4 Re^-0.343) / (1 + 10^(3C) Re^-(1+4C)/2).
/// The last term is written with Re^0.657, and the power of Re in its denominator multiplied out: finite at zero slip.
/// @source  Beetstra, van der Hoef, Kuipers (2007), AIChE Journal 53, 489.
[[nodiscard]] inline double drag_beetstra(const DragInput& in)
{
    const double phi = std::max(in.phi, smallest_closure_fraction), solid = 1.0 - phi;
    const double reynolds = in.density * phi * in.slip * in.diameter / in.viscosity;
    const double creeping = 10.0 * solid / (phi * phi) + phi * phi * (1.0 + 1.5 * std::sqrt(solid));
    const double power = std::pow(reynolds, 0.5 * (1.0 + 4.0 * solid));
    const double over_reynolds = (1.0 / phi + 3.0 * phi * solid) * reynolds + 8.4 * std::pow(reynolds, 0.657);
    const double inertial = 0.413 / (24.0 * phi * phi) * over_reynolds * power / (power + std::pow(10.0, 3.0 * solid));
    return 3.0 * std::numbers::pi * in.viscosity * in.diameter * phi * (creeping + inertial);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Drag law of Rong, Dong and Yu.
#include "physics/coupling/drag.hpp"

namespace physics {

/// Di Felice's form with an exponent fitted to resolved flow through packings, for phi from 0.37 and Re = rho phi |u-v| d / mu to
/// 3000 [kg/s]: chi = 2.65 (phi + 1) - (5.3 - 3.5 phi) phi^2 exp(-(1.5 - log10 Re)^2 / 2), beside the pressure-gradient force.
/// @source  Rong, Dong, Yu (2013), Chemical Engineering Science 99, 44; Dalla Valle (1948) for C_D.
[[nodiscard]] inline double drag_rong(const DragInput& in)
{
    const double phi = std::max(in.phi, smallest_closure_fraction);
    const double reynolds = in.density * phi * in.slip * in.diameter / in.viscosity;
    const double decades = 1.5 - std::log10(std::max(reynolds, 1e-12));
    const double chi = 2.65 * (phi + 1.0) - (5.3 - 3.5 * phi) * phi * phi * std::exp(-0.5 * decades * decades);
    return drag_dalla_valle(reynolds, in) * std::pow(phi, 1.0 - chi);
}

} // namespace physics

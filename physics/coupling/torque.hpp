// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Torque of the fluid on a spinning grain, and the spin after a step with it.
#include "core/base/vec3.hpp"

#include <cmath>
#include <numbers>

namespace physics {

/// Factor t of the torque T = t Omega, Omega = curl u / 2 - spin [N m s]; finite at Omega = 0.
/// T = (rho/2)(d/2)^5 C_R |Omega| Omega with C_R = 64 pi / Re up to Re = 32 (t = pi mu d^3), 12.9 / sqrt Re + 128.4 / Re
/// above, Re = rho d^2 |Omega| / mu.
/// @source  Rubinow, Keller (1961); Dennis, Singh, Ingham (1980), up to Re = 1000. Jump of 0.2 % at 32.
[[nodiscard]] inline double torque_factor(double relative_spin, double diameter, double density, double viscosity)
{
    const double d = diameter;
    const double creeping = std::numbers::pi * viscosity * d * d * d;
    const double reynolds = density * d * d * relative_spin / viscosity;
    if (reynolds <= 32.0) return creeping;
    return creeping * (12.9 * std::sqrt(reynolds) + 128.4) / (64.0 * std::numbers::pi);
}

/// Spin after dt under the fluid's torque alone, exact for a constant factor.
/// @param inertia  Moment of inertia, m d^2 / 10 [kg m2].
[[nodiscard]] inline core::Vec3 spin_after(const core::Vec3& spin, const core::Vec3& vorticity, double factor, double inertia, double dt)
{
    const core::Vec3 relative = spin - 0.5 * vorticity;
    return spin + std::expm1(-factor * dt / inertia) * relative;
}

} // namespace physics

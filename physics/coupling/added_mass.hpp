// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Added mass of a grain: the fluid it must accelerate with itself.
#include <algorithm>

namespace physics {

/// Coefficient of one sphere in unbounded inviscid fluid.
inline constexpr double added_mass_of_a_sphere = 0.5;

/// Added-mass coefficient in a suspension, (1/2)(1 + 2C)/(1 - C); C is clipped to at most 0.6.
/// @source  Zuber (1964).
[[nodiscard]] inline double added_mass_zuber(double solid_fraction)
{
    const double c = std::clamp(solid_fraction, 0.0, 0.6);
    return added_mass_of_a_sphere * (1.0 + 2.0 * c) / (1.0 - c);
}

/// Added mass a = C_m rho V [kg]; the force is a (Du/Dt - dv/dt).
[[nodiscard]] inline double added_mass(double coefficient, double fluid_density, double volume)
{
    return coefficient * fluid_density * volume;
}

} // namespace physics

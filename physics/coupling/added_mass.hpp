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

/// Share of what a held grain has not been told of the fluid's acceleration that it is told in each step.
inline constexpr double told_share = 0.25;

/// Acceleration of the fluid that enters the added-mass force of a step; what is left out is owed (true_up.hpp).
///
/// The fluid's acceleration of the last step, with what is owed, amounts to a linear extrapolation: second order for a free
/// grain. But where contacts hold a bed like springs it may sway, by an angle t in a step, and the fluid with it; a force
/// that comes late, with a factor G, feeds that motion by up to a / (m + a) (-Im G) sin^2(t / 2) / t in each step. For the
/// extrapolation the factor of a / (m + a) reaches 0.93, at t = 2; contacts damp such a slow mode by less. So a held grain
/// takes only a quarter of what it has not been told yet, G = z / (4 - 3 z), z = exp(-i t): at most 0.07. It hears all, but
/// later; a grain that is held moves no different for it.
/// @param now   Fluid acceleration of the last step at the grain.
/// @param told  What this function returned in the last step.
/// @param hold  Hold of the last step, 0 to 1 (contact_share.hpp).
template <class Vector>
[[nodiscard]] Vector told_acceleration(const Vector& now, const Vector& told, double hold)
{
    return now - hold * (now + (1.0 - told_share) * (now - told));
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From when on a force that is left out would be 1 % of the Stokes drag on a grain (NUMERICS E).
#include <cmath>
#include <numbers>

namespace physics {

/// What of a force may be left out [-].
inline constexpr double left_out_share = 0.01;

/// Shear at which Saffman's lift over Stokes drag, 1.615 / (3 pi) sqrt(G d^2 / nu), reaches the share [1/s].
/// @param diffusion  nu / d^2 [1/s].
[[nodiscard]] inline double shear_of_lift(double diffusion)
{
    const double root = left_out_share * 3.0 * std::numbers::pi / 1.615;
    return root * root * diffusion;
}

/// Relative spin at which Magnus lift by Rubinow and Keller over Stokes drag, d^2 spin / (24 nu), reaches the share [1/s].
[[nodiscard]] inline double spin_of_lift(double diffusion) { return left_out_share * 24.0 * diffusion; }

/// Angular frequency at which the history force over Stokes drag, sqrt(omega d^2 / (8 nu)), reaches the share [1/s].
[[nodiscard]] inline double frequency_of_history(double diffusion) { return left_out_share * left_out_share * 8.0 * diffusion; }

/// Share of the response (1 + C_m) / (s + C_m) that added mass makes of a grain of density ratio s, against 1 / s without.
[[nodiscard]] inline double added_mass_of_response(double ratio, double coefficient)
{
    return std::abs((1.0 + coefficient) / (ratio + coefficient) - 1.0 / ratio);
}

/// Time in which viscous torque stops a spin, rho_p d^2 / (60 mu) [s]: over times much shorter it may be left out.
[[nodiscard]] inline double spin_time(double density, double diffusion, double fluid_density)
{
    return density / (60.0 * fluid_density * diffusion);
}

} // namespace physics

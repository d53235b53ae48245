// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Turbulence that works on the drag of grains which do not follow it: a bed lets none in.
#include "physics/fluid/k_epsilon.hpp"
#include <algorithm>
#include <cmath>

namespace physics {

/// Grains in a cell, per volume of the cell.
struct GrainResistance {
    double drag = 0.0; ///< sum of K [kg/(m3 s)]
    double mass = 0.0; ///< of grains and what they carry along [kg/m3]
};

/// Rate at which k falls by the drag of grains on fluctuations, 2 drag (1 - t) / (fluid mass per volume): of the fluctuations grains follow
/// the share t = exp(-St / 4), St the time in which grains follow over that of eddies, k / (6 epsilon) [1/s].
/// @param fluid  Mass of the fluid per volume of the cell [kg/m3].
/// @source  Hsu, Jenkins, Liu (2004), with the share and its constant as calibrated for sheet flow in sedFoam, Chauchat and others (2017).
[[nodiscard]] inline double turbulence_damping(const GrainResistance& grains, double fluid, const Turbulence& at)
{
    if (grains.drag == 0.0) return 0.0;
    constexpr double following = 0.25, eddies = 6.0;
    const double stokes = grains.mass / grains.drag * eddies * at.epsilon / at.k;
    return -2.0 * grains.drag * std::expm1(-following * stokes) / fluid;
}

/// What a step leaves of turbulence under a constant rate of damping [1/s]; epsilon falls by 1.2 of it. @source  As turbulence_damping().
[[nodiscard]] inline Turbulence damped(const Turbulence& at, double rate, double dt)
{
    constexpr double of_epsilon = 1.2;
    return {std::max(at.k * std::exp(-rate * dt), least_turbulence.k),
            std::max(at.epsilon * std::exp(-of_epsilon * rate * dt), least_turbulence.epsilon)};
}

} // namespace physics

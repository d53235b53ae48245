// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Turbulent velocity that a grain meets and a model of turbulence does not resolve, as a random process along the grain's way.
//
// Over its standard deviation s the fluctuation g obeys dg = (grad s - g / T) dt + sqrt(2 / T) dW. The drift grad s keeps what is well
// mixed so: with it the density of particles that follow u + s g stays uniform where s is not. Within a step s, T and grad s are those of
// its start, and the process is drawn exactly, its end together with its mean, so that neither long nor short steps spread grains wrongly.
#include "core/base/vec3.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace physics {

/// Turbulence around a grain.
struct SeenTurbulence {
    double deviation = 0.0;                 ///< s, of each component: sqrt(2 k / 3) [m/s]
    core::Vec3 growth = core::Vec3::Zero(); ///< grad s [1/s]
    double rate = 0.0;                      ///< 1 / T of the fluid's own fluctuations [1/s]
};

/// Standard deviation of each component of velocity [m/s]. @param k  [m2/s2].
[[nodiscard]] inline double fluctuation_deviation(double k) { return std::sqrt(2.0 / 3.0 * k); }

/// Rate at which fluctuations are forgotten along the way of the fluid [1/s]. @param k  [m2/s2], positive. @param epsilon  [m2/s3].
/// @source  T = 0.3 k / epsilon: Milojevic (1990); Berlemont and others (1990) have 0.27 to 0.41.
[[nodiscard]] inline double fluctuation_rate(double k, double epsilon)
{
    constexpr double share = 0.3;
    return epsilon / (share * k);
}

/// The rate as a grain finds it that falls through eddies with a mean slip [1/s].
/// @source  Csanady (1963), along the slip, with equal time scales of fluid and eddies; taken for all directions.
[[nodiscard]] inline double crossing_rate(const SeenTurbulence& seen, double slip)
{
    return seen.rate * std::hypot(1.0, slip / seen.deviation);
}

/// What a step draws for one component: two normal numbers.
using FluctuationDraw = std::array<double, 2>;

/// The fluctuation over its deviation.
struct Fluctuation {
    double at_end = 0.0; ///< of the step [-]
    double mean = 0.0;   ///< over the step, with what a deviation that is taken constant on the way leaves out [-]
};

/// One component over a step. @param before  At the start [-]. @param drift  Of grad s [1/s]. @param rate  1 / T [1/s].
/// @source  Gillespie (1996) for the joint distribution of the end and the integral.
[[nodiscard]] inline Fluctuation fluctuate(double before, double drift, double rate, double dt, const FluctuationDraw& draw)
{
    constexpr double forgotten = 1e8; // steps longer than that many times T differ from such by less than round-off
    const double x = std::min(rate * dt, forgotten), left = std::exp(-x), gone = -std::expm1(-x);
    const double seen = x > 0.0 ? gone / x : 1.0; // share of what was there at the start in the mean
    const double reach = drift * dt * (x > 0.0 ? (1.0 - seen) / x : 0.5);
    const double push = drift * dt * seen;
    const double together = x > 0.0 ? gone * std::sqrt(gone / (1.0 + left)) / x : 0.0;
    const double apart = x < 1e-2 ? std::sqrt(x * (1.0 / 6.0 - x * x / 60.0)) : std::sqrt(2.0 * x - 4.0 * std::tanh(0.5 * x)) / x;
    return {left * before + push + std::sqrt(gone * (1.0 + left)) * draw[0],
            seen * before + 2.0 * reach + together * draw[0] + apart * draw[1]};
}

} // namespace physics

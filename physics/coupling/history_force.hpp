// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Basset's history force on a grain: what vorticity that earlier accelerations shed still does to it.
#include "core/base/vec3.hpp"
#include <array>
#include <cmath>
#include <numbers>

namespace physics {

/// Factor c of the force -c int g(s) / sqrt(t - s) ds, g the acceleration of the grain relative to the fluid:
/// (3/2) d^2 sqrt(pi rho mu) [kg / sqrt s].
/// @source  Basset (1888); Maxey, Riley (1983).
[[nodiscard]] inline double history_factor(double diameter, double density, double viscosity)
{
    return 1.5 * diameter * diameter * std::sqrt(std::numbers::pi * density * viscosity);
}

/// Rate at which a slip of Reynolds number Re carries away what was shed [1/s]. Of the kernel of Mei and Adrian,
/// (1 + (t / t_f)^(3/4))^-2 / sqrt t with t_f = (4 / pi)^(1/3) ((0.75 + 0.105 Re) / Re)^2 d^2 / nu, this keeps the integral:
/// exp(-rate t) / sqrt t, 1 / rate = (64 pi / 243) t_f.
/// @param viscous_time  d^2 / nu [s].
/// @source  Mei, Adrian (1992), Journal of Fluid Mechanics 237, 323; Mei (1994), 270, 133.
[[nodiscard]] inline double history_fading(double reynolds, double viscous_time)
{
    const double ratio = reynolds / (0.75 + 0.105 * reynolds);
    return 243.0 / (64.0 * std::numbers::pi) * std::cbrt(0.25 * std::numbers::pi) * ratio * ratio / viscous_time;
}

/// Tail of the kernel as a sum of decaying exponentials, 1 / sqrt t = sum of weight_k exp(-rate_k t): the trapezoidal rule for
/// int exp(x/2 - t e^x) dx / sqrt pi with a step of 1.5 in x, off by 0.4 % at most between d^2 / (10^5 nu) and 30 d^2 / nu; beyond,
/// the force fades. Where the slip carries vorticity away, all modes fade with it.
/// @source  the idea of tails: van Hinsberg, ten Thije Boonkkamp, Clercx (2011), Journal of Computational Physics 230, 1465.
struct HistoryTail {
    static constexpr int modes = 13;
    /// @param viscous_time  d^2 / nu [s].   @param fading  history_fading() [1/s].
    explicit HistoryTail(double viscous_time, double fading = 0.0)
    {
        constexpr double spacing = 1.5;
        for (std::size_t k = 0; k < modes; ++k) {
            rate[k] = std::exp(spacing * double(k)) / (1000.0 * viscous_time);
            weight[k] = spacing * std::sqrt(rate[k] / std::numbers::pi);
            rate[k] += fading;
        }
    }
    std::array<double, modes> rate{};   ///< [1/s]
    std::array<double, modes> weight{}; ///< [1/sqrt s]
};

/// What a grain remembers of one component of g: its mean over the last step, and all steps before in modes.
struct HistoryMemory {
    double last = 0.0;                             ///< mean of g over the last step [m/s2]
    std::array<double, HistoryTail::modes> mode{}; ///< int g(s) exp(-rate (t - s)) ds over all before the last step, t its end [m/s]
};

/// Integral of g over the window of the step itself acts like more added mass: mean over a step of 2 c sqrt(t - t_n) [kg].
[[nodiscard]] inline double history_mass(double factor, double dt) { return 4.0 / 3.0 * factor * std::sqrt(dt); }

/// Mean over the coming step of the force of all that is past, over -c [m/s2 sqrt s]: the last step exactly, the rest by its modes.
[[nodiscard]] inline double history_of(const HistoryMemory& memory, const HistoryTail& tail, double dt, double dt_last)
{
    const auto power = [](double t) { return t * std::sqrt(t); };
    double sum = 4.0 / 3.0 * (power(dt + dt_last) - power(dt) - power(dt_last)) / dt * memory.last;
    for (std::size_t k = 0; k < HistoryTail::modes; ++k)
        sum -= tail.weight[k] / (tail.rate[k] * dt) * std::expm1(-tail.rate[k] * dt) * memory.mode[k];
    return sum;
}

/// Memory after a step of length dt over which g was `mean`. The step before it, of length dt_last, joins the modes.
[[nodiscard]] inline HistoryMemory remembered(const HistoryMemory& memory, const HistoryTail& tail, double mean, double dt, double dt_last)
{
    HistoryMemory after{mean, {}};
    for (std::size_t k = 0; k < HistoryTail::modes; ++k) {
        const double gained = -std::expm1(-tail.rate[k] * dt_last) / tail.rate[k] * memory.last;
        after.mode[k] = std::exp(-tail.rate[k] * dt) * (memory.mode[k] + gained);
    }
    return after;
}

} // namespace physics

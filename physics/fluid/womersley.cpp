// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/womersley.hpp"
#include "core/base/error.hpp"
#include <cmath>
#include <numbers>

namespace physics {
namespace {

using Complex = std::complex<double>;

/// Below, the power series loses three digits at most to cancellation; above, the asymptotic series is exact to round-off.
constexpr double largest_argument_of_series = 20.0;

Complex power_series(int order, Complex w)
{
    constexpr int terms = 60; // |w / 2|^120 / 60!^2 is below 1e-40 of the first terms
    Complex term = order == 0 ? 1.0 : 0.5 * w, sum = term;
    for (int m = 1; m < terms; ++m) sum += term *= 0.25 * w * w / double(m * (m + order));
    return sum * std::exp(-w);
}

/// @source  Abramowitz & Stegun (1964), 9.7.1.
Complex asymptotic_series(int order, Complex w)
{
    constexpr int terms = 20; // they shrink until k = 2 |w| >= 40
    Complex term = 1.0, sum = term;
    for (int k = 1; k < terms; ++k) {
        const double odd = 2 * k - 1;
        sum += term *= -(4.0 * order * order - odd * odd) / (8.0 * k * w);
    }
    return sum / std::sqrt(2.0 * std::numbers::pi * w);
}

Complex scaled_bessel(int order, Complex w)
{
    return std::abs(w) < largest_argument_of_series ? power_series(order, w) : asymptotic_series(order, w);
}

} // namespace

Complex scaled_bessel_0(Complex w) { return scaled_bessel(0, w); }
Complex scaled_bessel_1(Complex w) { return scaled_bessel(1, w); }

WomersleyFlow::WomersleyFlow(const Parameters& p)
    : parameters_(p), alpha_(p.radius * std::sqrt(p.angular_frequency / p.viscosity)), wall_(std::polar(alpha_, 0.25 * std::numbers::pi))
{
    core::require<core::ConfigError>(p.radius > 0 && p.viscosity > 0 && p.angular_frequency > 0,
                                     "an oscillating pipe flow needs a radius, a viscosity and a frequency above zero");
}

Complex WomersleyFlow::amplitude(double r) const
{
    const double share = r / parameters_.radius;
    return inviscid() * (1.0 - scaled_bessel_0(share * wall_) / scaled_bessel_0(wall_) * std::exp((share - 1.0) * wall_));
}

Complex WomersleyFlow::mean_amplitude() const
{
    return inviscid() * (1.0 - 2.0 * scaled_bessel_1(wall_) / (wall_ * scaled_bessel_0(wall_)));
}

} // namespace physics

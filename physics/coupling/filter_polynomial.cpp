// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/filter_polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace physics {

std::vector<double> diffusion_steps(double a)
{
    if (!(a > 0.0)) return {};
    const double half = std::min(0.5, 0.5 * a);
    std::vector<double> steps(2, half);
    const double rest = a - 2.0 * half;
    const int whole = int(std::ceil(rest));
    steps.insert(steps.end(), std::size_t(whole), rest / std::max(1, whole));
    return steps;
}

std::vector<double> chebyshev_exponential(double a, double tolerance)
{
    if (!(a > 0.0)) return {1.0};
    // Scaled Bessel functions exp(-a) I_k(a) from their recurrence, downwards from far beyond the last that counts.
    const int start = 20 + int(a + 12.0 * std::sqrt(a + 40.0));
    std::vector<double> bessel(std::size_t(start) + 2, 0.0);
    bessel[std::size_t(start)] = 1e-250;
    for (int k = start; k > 0; --k) {
        const auto n = std::size_t(k);
        bessel[n - 1] = bessel[n + 1] + 2.0 * k / a * bessel[n];
        if (bessel[n - 1] > 1e200)
            for (std::size_t m = n - 1; m < bessel.size(); ++m) bessel[m] *= 1e-200;
    }
    double total = bessel[0];
    for (std::size_t k = 1; k < bessel.size(); ++k) total += 2.0 * bessel[k];
    std::vector<double> c{bessel[0] / total};
    double value = c[0]; // of the sum at y = -1, where T_k = (-1)^k
    for (std::size_t k = 1; k < bessel.size() && 1.0 - value > tolerance; ++k) {
        const double term = 2.0 * bessel[k] / total;
        c.push_back(k % 2 == 0 ? term : -term);
        value += term;
    }
    for (double& x : c) x /= value;
    return c;
}

} // namespace physics

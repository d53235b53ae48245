// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/restitution.hpp"
#include "core/base/error.hpp"

#include <cmath>
#include <numbers>

namespace physics {

double restitution_of(double z)
{
    if (z < 1.0) {
        const double w = std::sqrt(1.0 - z * z);
        return std::exp(-z / w * (std::numbers::pi - std::atan2(2.0 * z * w, 1.0 - 2.0 * z * z)));
    }
    const double w = std::sqrt(z * z - 1.0);
    if (w < 1e-6) return std::exp(-2.0); // critical damping
    const double t = std::atanh(2.0 * z * w / (2.0 * z * z - 1.0)) / w;
    return -std::exp(-z * t) * (std::cosh(w * t) - z / w * std::sinh(w * t));
}

double damping_of(double restitution)
{
    core::require<core::ConfigError>(restitution >= 0.01 && restitution <= 1.0,
                                     core::text("restitution ", restitution, " is not within 0.01..1"));
    if (restitution == 1.0) return 0.0;
    double low = 0.0, high = 16.0;
    for (int k = 0; k < 64; ++k) {
        const double middle = 0.5 * (low + high);
        (restitution_of(middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace physics

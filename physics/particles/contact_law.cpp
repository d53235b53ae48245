// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact_law.hpp"
#include "core/base/error.hpp"

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

LinearContact linear_contact(const ContactParameters& p, double step)
{
    using core::require, core::ConfigError, core::text;
    require<ConfigError>(p.stiffness > 0, text("contact stiffness ", p.stiffness, " N/m is not positive"));
    require<ConfigError>(p.friction >= 0, text("friction ", p.friction, " is negative"));
    require<ConfigError>(p.tangential_stiffness >= 0, text("tangential stiffness ", p.tangential_stiffness, " is negative"));
    LinearContact law;
    law.stiffness = p.stiffness;
    law.tangential_stiffness = p.tangential_stiffness * p.stiffness;
    law.compliance = law.tangential_stiffness > 0 ? 1.0 / law.tangential_stiffness : 0.0;
    law.damping = 2.0 * damping_of(p.restitution) * std::sqrt(p.stiffness);
    // the same damping ratio across the normal, where the reduced mass of two spheres is 2/7 of m*
    law.tangential_damping = law.damping * std::sqrt(2.0 / 7.0 * p.tangential_stiffness);
    law.friction = p.friction;
    law.step = step;
    return law;
}

} // namespace physics

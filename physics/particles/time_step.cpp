// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/time_step.hpp"
#include "core/base/error.hpp"
#include "physics/particles/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace physics {
namespace {

constexpr int dense_contacts = 12;
constexpr double fewest_steps_per_contact = 10.0;
constexpr double usual_steps_per_contact = 30.0;

} // namespace

double contact_time(const ContactParameters& contact, double mass)
{
    const double zeta = damping_of(contact.restitution);
    const double period = std::numbers::pi * std::sqrt(mass / contact.stiffness);
    return zeta < 1.0 ? period / std::sqrt(1.0 - zeta * zeta) : period;
}

double stable_step(const ContactParameters& contact, double mass, int contacts)
{
    const double zeta = damping_of(contact.restitution);
    const double stiffness = contact.stiffness * std::max(1.0, 3.5 * contact.tangential_stiffness);
    const double omega = std::sqrt(2.0 * contacts * stiffness / mass);
    return 2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta);
}

StepLimits step_limits(const core::ParticleSet& particles, const ParticleParameters& parameters)
{
    const double never = std::numeric_limits<double>::infinity();
    StepLimits limits{never, never};
    double lightest = never;
    for (int i = 0; i < particles.owned; ++i) lightest = std::min(lightest, particles.mass[std::size_t(i)]);
    if (lightest == never) return limits;
    for (const auto& contact : parameters.pairs) {
        limits.contact_time = std::min(limits.contact_time, contact_time(contact, 0.5 * lightest));
        limits.stable = std::min(limits.stable, stable_step(contact, lightest, dense_contacts));
    }
    for (const auto& contact : parameters.walls) {
        limits.contact_time = std::min(limits.contact_time, contact_time(contact, lightest));
        limits.stable = std::min(limits.stable, stable_step(contact, lightest, 1));
    }
    return limits;
}

double choose_step(const StepLimits& limits, double wanted)
{
    using core::require, core::ConfigError, core::text;
    if (wanted == 0.0) return std::min(limits.contact_time / usual_steps_per_contact, 0.5 * limits.stable);
    require<ConfigError>(wanted > 0.0, text("particle time step ", wanted, " s is not positive: remove it to let the solver choose"));
    require<ConfigError>(wanted <= limits.stable, text("particle time step ", wanted, " s is above the stable limit ", limits.stable,
                                                       " s: make it smaller or the contacts softer"));
    require<ConfigError>(wanted * fewest_steps_per_contact <= limits.contact_time,
                         text("particle time step ", wanted, " s resolves a contact of ", limits.contact_time, " s by fewer than ",
                              fewest_steps_per_contact, " steps"));
    return wanted;
}

} // namespace physics

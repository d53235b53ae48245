// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/time_step.hpp"
#include "core/base/error.hpp"
#include "physics/particles/lubrication.hpp"
#include "physics/particles/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace physics {
namespace {

constexpr int dense_contacts = 12;
constexpr double fewest_steps_per_contact = 20.0;
constexpr double usual_steps_per_contact = 30.0;
constexpr double usual_share = 0.5; // of the stable step

} // namespace

double greatest_overlap(const ContactParameters& c, const ContactBody& body)
{
    return std::pow(15.0 * body.mass * c.impact_speed * c.impact_speed / (16.0 * c.young_modulus * std::sqrt(body.radius)), 0.4);
}

double contact_time(const ContactParameters& contact, const ContactBody& body)
{
    if (contact.model == ContactModel::hertz) return 2.9432752 * greatest_overlap(contact, body) / contact.impact_speed;
    const double zeta = damping_of(contact.restitution);
    const double period = std::numbers::pi * std::sqrt(body.mass / contact.stiffness);
    return zeta < 1.0 ? period / std::sqrt(1.0 - zeta * zeta) : period;
}

double stiffness_of(double time, double mass, double restitution)
{
    const double zeta = damping_of(restitution), rate = std::numbers::pi / time;
    return mass * rate * rate / (zeta < 1.0 ? 1.0 - zeta * zeta : 1.0);
}

double normal_stiffness(const ContactParameters& contact, const ContactBody& body)
{
    if (contact.model == ContactModel::linear) return contact.stiffness;
    return 2.0 * contact.young_modulus * std::sqrt(body.radius * greatest_overlap(contact, body));
}

double stable_step(const ContactParameters& contact, const ContactBody& body, double mass, int contacts)
{
    constexpr double turning_damping = 0.6; // 0.3 of what is critical for rolling, more where a ball turns in its place
    const bool hertz = contact.model == ContactModel::hertz;
    const double tangential = hertz ? 4.0 * contact.shear_modulus / contact.young_modulus : contact.tangential_stiffness;
    const double turning = contact.rolling == RollingModel::spring ? std::max(contact.rolling_friction, contact.twisting_friction) : 0.0;
    const double stiffness = normal_stiffness(contact, body) * std::max({1.0, 3.5 * tangential, 5.6 * turning * turning});
    const double omega = std::sqrt(2.0 * contacts * stiffness / mass);
    // the fastest mode feels the dashpots of all contacts: its damping ratio is greater, as its frequency is
    const double single = std::max(damping_of(contact.restitution), turning > 0.0 ? turning_damping : 0.0);
    const double zeta = single * std::sqrt(2.0 * contacts * body.mass / mass);
    return 2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta);
}

StepLimits step_limits(const core::ParticleSet& particles, const ParticleParameters& parameters)
{
    const double never = std::numeric_limits<double>::infinity();
    StepLimits limits{never, never};
    const auto tighten = [&](const ContactParameters& contact, const ContactBody& body, double mass, int contacts) {
        limits.contact_time = std::min(limits.contact_time, contact_time(contact, body));
        limits.stable = std::min(limits.stable, stable_step(contact, body, mass, contacts));
    };
    const auto pairs_of = [&, all = std::span(parameters.pairs)](std::int32_t species) {
        const auto each = std::size_t(parameters.species);
        return all.size() == 1 ? all : all.subspan(std::size_t(species) * each, each);
    };
    double greatest = 0.0;
    for (std::size_t i = 0; i < std::size_t(particles.owned); ++i) greatest = std::max(greatest, particles.radius[i]);
    for (std::size_t i = 0; i < std::size_t(particles.owned); ++i) {
        const double mass = particles.mass[i], radius = particles.radius[i];
        if (parameters.film.acts()) {
            const double reduced = radius * greatest / (radius + greatest);
            limits.stable = std::min(
                {limits.stable, film_step(parameters.film, mass, reduced, dense_contacts), film_step(parameters.film, mass, radius, 1)});
        }
        for (const auto& contact : pairs_of(particles.species[i])) tighten(contact, {0.5 * mass, 0.5 * radius}, mass, dense_contacts);
        for (std::size_t n = 0; n < parameters.walls.size(); ++n)
            if (parameters.walls.size() == 1 || n % std::size_t(parameters.species) == std::size_t(particles.species[i]))
                tighten(parameters.walls[n], {mass, radius}, mass, 1);
    }
    return limits;
}

double choose_step(const StepLimits& limits, double wanted)
{
    using core::require, core::ConfigError, core::text;
    if (wanted == 0.0) return std::min(limits.contact_time / usual_steps_per_contact, usual_share * limits.stable);
    require<ConfigError>(wanted > 0.0, text("particle time step ", wanted, " s is not positive: remove it to let the solver choose"));
    require<ConfigError>(wanted <= limits.stable, text("particle time step ", wanted, " s is above the stable limit ", limits.stable,
                                                       " s: make it smaller or the contacts softer"));
    require<ConfigError>(wanted * fewest_steps_per_contact <= 1.000001 * limits.contact_time, // rounding
                         text("particle time step ", wanted, " s resolves a contact of ", limits.contact_time, " s by fewer than ",
                              fewest_steps_per_contact, " steps"));
    return wanted;
}

} // namespace physics

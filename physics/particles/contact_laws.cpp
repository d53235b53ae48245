// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact_laws.hpp"
#include "core/base/error.hpp"
#include "physics/particles/restitution.hpp"

#include <algorithm>
#include <numbers>

namespace physics {
namespace {

using core::require, core::ConfigError, core::text;

void check_friction(const ContactParameters& p)
{
    require<ConfigError>(p.friction >= 0, text("friction ", p.friction, " is negative"));
    require<ConfigError>(p.rolling_friction >= 0 && p.twisting_friction >= 0,
                         text("rolling friction ", p.rolling_friction, " or twisting friction ", p.twisting_friction, " is negative"));
    require<ConfigError>(p.cohesion >= 0, text("work of adhesion ", p.cohesion, " J/m2 is negative"));
}

bool is_plain(const ContactParameters& p) { return p.rolling_friction == 0 && p.twisting_friction == 0 && p.cohesion == 0; }

void check_film(const LubricationFilm& film)
{
    require<ConfigError>(film.roughness > 0 && film.range > film.roughness,
                         text("the roughness of a film of lubrication, ", film.roughness,
                              " m, must be more than 0 and less than its range, ", film.range, " m"));
}

ContactLaws laws_of(const std::vector<ContactParameters>& entries, int wanted, const LubricationFilm& film, double step)
{
    const int count = int(entries.size());
    require<ConfigError>(count == 1 || count == wanted,
                         text(count, " sets of contact parameters are given where 1 or ", wanted, " are needed"));
    const auto all = [&](ContactModel model) {
        return std::all_of(entries.begin(), entries.end(), [&](const auto& p) { return is_plain(p) && p.model == model; });
    };
    const auto made = [&](auto make) {
        std::vector<decltype(make(entries.front(), step))> laws;
        for (const auto& entry : entries) laws.push_back(make(entry, step));
        return ContactLaws(std::move(laws));
    };
    if (film.acts()) {
        check_film(film);
        return made([&](const ContactParameters& p, double h) { return LubricatedContact{general_contact(p, h), film}; });
    }
    if (all(ContactModel::linear)) return made(linear_contact);
    if (all(ContactModel::hertz)) return made(hertz_contact);
    return made(general_contact);
}

} // namespace

std::vector<int> kinds_of(const ContactLaws& laws, int count)
{
    std::vector<int> kinds(std::size_t(count), 0);
    std::visit(
        [&](const auto& entries) {
            for (std::size_t n = 0; entries.size() > 1 && n < kinds.size(); ++n)
                kinds[n] = int(std::find(entries.begin(), entries.end(), entries[n]) - entries.begin());
        },
        laws);
    return kinds;
}

LinearContact linear_contact(const ContactParameters& p, double step)
{
    require<ConfigError>(p.stiffness > 0, text("contact stiffness ", p.stiffness, " N/m is not positive"));
    require<ConfigError>(p.tangential_stiffness >= 0, text("tangential stiffness ", p.tangential_stiffness, " is negative"));
    check_friction(p);
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

HertzContact hertz_contact(const ContactParameters& p, double step)
{
    require<ConfigError>(p.young_modulus > 0 && p.shear_modulus > 0,
                         text("effective moduli of a contact, ", p.young_modulus, " Pa and ", p.shear_modulus, " Pa, are not positive"));
    check_friction(p);
    HertzContact law;
    law.modulus = 4.0 / 3.0 * p.young_modulus;
    law.tangential_modulus = 8.0 * p.shear_modulus;
    // 2 sqrt(5/6) zeta sqrt(S m) with the tangent stiffness S = 2 E a, and 8 G a for the 2/7 of m* across the normal
    const double damping = 2.0 * std::sqrt(5.0 / 6.0) * damping_of(p.restitution);
    law.damping = damping * std::sqrt(2.0 * p.young_modulus);
    law.tangential_damping = damping * std::sqrt(2.0 / 7.0 * law.tangential_modulus);
    law.friction = p.friction;
    law.step = step;
    return law;
}

GeneralContact general_contact(const ContactParameters& p, double step)
{
    constexpr double sphere_inertia = 0.4;
    GeneralContact law;
    if (p.model == ContactModel::linear) law.linear = linear_contact(p, step);
    else law.hertz = hertz_contact(p, step);
    law.friction = p.friction;
    law.step = step;
    law.rolling = p.rolling_friction;
    law.twisting = p.twisting_friction;
    law.turning_spring = p.rolling == RollingModel::spring ? 1.0 : 0.0;
    law.stop = p.rolling == RollingModel::spring || step == 0 ? 0.0 : sphere_inertia / step;
    law.pull = 2.0 * std::numbers::pi * p.cohesion;
    return law;
}

ContactLaws pair_laws(const ParticleParameters& parameters, double step)
{
    return laws_of(parameters.pairs, parameters.species * parameters.species, parameters.film, step);
}

ContactLaws wall_laws(const ParticleParameters& parameters, double step)
{
    return laws_of(parameters.walls, parameters.wall_materials * parameters.species, parameters.film, step);
}

} // namespace physics

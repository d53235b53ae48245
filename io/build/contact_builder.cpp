// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/contact_builder.hpp"
#include "io/build/physics_builder.hpp"
#include "io/build/wall_materials.hpp"
#include "physics/particles/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace io {
namespace {

using physics::ContactParameters;

/// Only a collision time asks for it, which wants sizes of all species.
double mean_mass(const Scene& scene, const Species& species)
{
    return scene.contact->collision_time ? std::numbers::pi / 6 * mean_cube(species) * species.density : 0.0;
}

/// Compliances of one material: (1 - nu^2) / E and 2 (2 - nu) (1 + nu) / E = (2 - nu) / G [1/Pa].
struct Compliance {
    double normal, tangential;
};

Compliance compliance_of(const Contact& contact, std::string_view name)
{
    double young = contact.young_modulus.value_or(0.0), poisson = contact.poisson_ratio.value_or(0.0);
    for (const ContactMaterial& material : contact.materials)
        if (material.of == name) {
            young = material.young_modulus;
            poisson = material.poisson_ratio;
        }
    return {(1 - poisson * poisson) / young, 2 * (2 - poisson) * (1 + poisson) / young};
}

/// The contact of two materials. @param mass  Reduced mass [kg].
ContactParameters parameters_of(const Contact& contact, std::string_view one, std::string_view other, double mass)
{
    ContactPair pair;
    for (const ContactPair& p : contact.pairs)
        if ((p.between[0] == one && p.between[1] == other) || (p.between[0] == other && p.between[1] == one)) pair = p;
    ContactParameters p;
    p.model = pair.law.value_or(contact.law);
    p.restitution = pair.restitution.value_or(contact.restitution);
    p.friction = pair.friction.value_or(contact.friction);
    p.rolling = contact.rolling;
    p.rolling_friction = pair.rolling_friction.value_or(contact.rolling_friction);
    p.twisting_friction = pair.twisting_friction.value_or(contact.twisting_friction);
    p.cohesion = pair.cohesion.value_or(contact.cohesion);
    if (p.model == ContactLaw::linear) {
        p.tangential_stiffness = contact.tangential_ratio;
        const bool timed = contact.collision_time && !pair.stiffness;
        p.stiffness = timed ? physics::stiffness_of(*contact.collision_time, mass, p.restitution)
                            : pair.stiffness.value_or(contact.stiffness.value_or(0.0));
    } else {
        const Compliance a = compliance_of(contact, one), b = compliance_of(contact, other);
        p.young_modulus = 1 / (a.normal + b.normal);
        p.shear_modulus = 1 / (a.tangential + b.tangential);
    }
    return p;
}

void unite(std::vector<ContactParameters>& all)
{
    if (std::all_of(all.begin(), all.end(), [&](const auto& p) { return p == all.front(); })) all.resize(1);
}

} // namespace

void set_contacts(const Scene& scene, physics::ParticleParameters& parameters)
{
    const double speed = impact_speed(scene);
    const auto add = [&](std::vector<ContactParameters>& all, std::string_view one, std::string_view other, double mass) {
        all.push_back(parameters_of(*scene.contact, one, other, mass));
        if (all.back().model == ContactLaw::hertz) all.back().impact_speed = speed;
    };
    parameters.species = int(scene.particles.size());
    parameters.pairs.clear();
    parameters.walls.clear();
    for (const Species& a : scene.particles)
        for (const Species& b : scene.particles) {
            const double mass = mean_mass(scene, a), other = mean_mass(scene, b);
            add(parameters.pairs, material_of(a), material_of(b), mass > 0 ? mass * other / (mass + other) : 0.0);
        }
    const WallMaterials walls(scene);
    parameters.wall_materials = int(walls.names().size());
    for (const std::string& wall : walls.names())
        for (const Species& a : scene.particles) add(parameters.walls, material_of(a), wall, mean_mass(scene, a));
    unite(parameters.pairs);
    unite(parameters.walls);
}

double impact_speed(const Scene& scene)
{
    if (scene.contact->impact_speed) return *scene.contact->impact_speed;
    double speed = 0;
    for (const Species& species : scene.particles) speed = std::max(speed, species.initial.velocity.norm());
    if (scene.gravity) {
        const core::Vec3 size = scene.grid.high() - scene.grid.low();
        speed = std::max(speed, std::sqrt(2 * scene.gravity->magnitude * scene.gravity->direction.cwiseAbs().dot(size)));
    }
    if (scene.fluid) {
        for (const Boundary& boundary : scene.fluid->boundaries)
            if (boundary.velocity) speed = std::max(speed, boundary.velocity->norm());
        if (scene.fluid->drive && scene.fluid->drive->bulk_velocity) speed = std::max(speed, std::abs(*scene.fluid->drive->bulk_velocity));
    }
    return speed;
}

BedContact bed_contact(const Scene& scene, const GrainCensus& census, const physics::ParticleParameters& parameters)
{
    BedContact softest{std::numeric_limits<double>::infinity(), 0.0};
    const double weight = census.mean_mass() * gravity_of(scene).norm();
    for (const ContactParameters& p : parameters.pairs) {
        const bool linear = p.model == ContactLaw::linear;
        if (!linear && census.count == 0) continue;          // no bed
        const double radius = 0.25 * census.mean_diameter(); // of two alike
        double stiffness = physics::normal_stiffness(p, {0.5 * census.mean_mass(), radius});
        if (!linear && weight > 0) // 4/3 E sqrt(R) delta^(3/2) = m g, k = 2 E sqrt(R delta)
            stiffness = std::cbrt(6 * p.young_modulus * p.young_modulus * radius * weight);
        if (stiffness < softest.stiffness) softest = {stiffness, linear ? p.tangential_stiffness : 4 * p.shear_modulus / p.young_modulus};
    }
    return softest;
}

} // namespace io

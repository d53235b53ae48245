// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world_grains.hpp"
#include "core/base/error.hpp"
#include "io/build/contact_builder.hpp"
#include "io/build/coupling_builder.hpp"
#include "io/build/grid_builder.hpp"
#include "io/build/physics_builder.hpp"
#include "io/run/world_walls.hpp"
#include "physics/coupling/bed_stiffness.hpp"
#include "physics/particles/time_step.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

/// The smallest diameter that particles of the species have or may have [m].
double smallest_of(const Species& species, const GrainCensus& census)
{
    if (!has_sizes(species)) return census.smallest; // from a file
    return species.count.value_or(0) > 0 && !species.inflow ? diameters_of(species).front() : size_range(species)[0];
}

/// A share of the shortest contact, within what is stable.
double sub_step(const Scene& scene, const GrainCensus& census, const physics::ParticleParameters& parameters)
{
    core::ParticleSet smallest; // of each species
    for (std::size_t n = 0; n < scene.particles.size() && std::isfinite(census.smallest); ++n) {
        core::Sphere sphere;
        sphere.radius = smallest_of(scene.particles[n], census) / 2;
        sphere.density = scene.particles[n].density;
        sphere.species = std::int32_t(n);
        smallest.add(sphere);
    }
    const physics::StepLimits limits = physics::step_limits(smallest, parameters);
    // strong damping asks for less than a share of the contact
    const double wanted = std::min(limits.contact_time / scene.contact->steps_per_contact, 0.5 * limits.stable);
    return physics::choose_step(limits, wanted);
}

} // namespace

physics::ParticleDynamics make_dynamics(const Scene& scene, const GrainCensus& census, const core::Mesh& mesh)
{
    physics::ParticleParameters parameters = particle_parameters(scene);
    parameters.film = lubrication_film(scene, census);
    const core::Domain domain = make_domain(scene.grid);
    const double step = sub_step(scene, census, parameters);
    require_slow_walls(scene.walls, census.smallest, domain, step);
    physics::ParticleDynamics dynamics(domain, parameters, primitive_walls(scene, domain), step);
    if (scene.contact->walls == WallShape::faces) dynamics.add_surface(grid_surface(census.largest, mesh, domain, WallMaterials(scene)));
    add_own_surfaces(scene, dynamics);
    return dynamics;
}

void add_grains(const std::vector<core::Sphere>& grains, const physics::OwnerOf& owner_of, int rank, physics::ParticleDynamics& dynamics)
{
    for (const core::Sphere& sphere : grains)
        if (owner_of(sphere.position) == rank) {
            dynamics.particles.add(sphere);
            dynamics.history.end_row();
        }
}

core::Vec3 settling_gravity(const Scene& scene, const GrainCensus& census)
{
    const core::Vec3 gravity = gravity_of(scene);
    if (!scene.fluid) return gravity;
    return (1 - scene.fluid->material.density * census.volume / census.mass) * gravity;
}

double bed_stiffness(const BedContact& contact, const core::Vec3& gravity, const GrainCensus& census, const core::Domain& domain,
                     double grains)
{
    double layers = 1.0;
    if (census.count > 0) layers = physics::bed_layers(domain, gravity, grains * census.volume / double(census.count), census.smallest);
    return physics::bed_stiffness(physics::layer_stiffness(contact.stiffness, contact.tangential_ratio * contact.stiffness), layers);
}

} // namespace io

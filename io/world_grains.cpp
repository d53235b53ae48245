// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/world_grains.hpp"
#include "core/base/error.hpp"
#include "io/grid_builder.hpp"
#include "io/physics_builder.hpp"
#include "io/world_walls.hpp"
#include "physics/coupling/bed_stiffness.hpp"
#include "physics/particles/time_step.hpp"
#include <algorithm>
#include <numbers>

namespace io {
namespace {

/// A share of the shortest contact, within what is stable.
double sub_step(const Scene& scene, double lightest, const physics::ParticleParameters& parameters)
{
    core::ParticleSet one;
    core::Sphere sphere;
    sphere.density = 1.0;
    sphere.radius = std::cbrt(0.75 * lightest / std::numbers::pi);
    one.add(sphere);
    const physics::StepLimits limits = physics::step_limits(one, parameters);
    return physics::choose_step(limits, limits.contact_time / scene.contact->steps_per_contact);
}

} // namespace

physics::ParticleDynamics make_dynamics(const Scene& scene, const GrainCensus& census, const core::Mesh& mesh)
{
    const physics::ParticleParameters parameters = particle_parameters(scene);
    const core::Domain domain = make_domain(scene.grid);
    const double step = sub_step(scene, census.lightest, parameters);
    require_slow_walls(scene.walls, census.smallest, domain, step);
    physics::ParticleDynamics dynamics(domain, parameters, primitive_walls(scene, domain), step);
    if (scene.contact->walls == WallShape::faces) dynamics.add_surface(grid_surface(census.largest, mesh, domain));
    add_own_surfaces(scene.walls, dynamics);
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

double bed_stiffness(const Scene& scene, const GrainCensus& census, const core::Domain& domain, double grains)
{
    double layers = 1.0;
    if (census.count > 0)
        layers = physics::bed_layers(domain, gravity_of(scene), grains * census.volume / double(census.count), census.smallest);
    const double normal = scene.contact->stiffness;
    return physics::bed_stiffness(physics::layer_stiffness(normal, scene.contact->tangential_ratio * normal), layers);
}

} // namespace io

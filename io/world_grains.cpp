// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/world_grains.hpp"
#include "core/base/error.hpp"
#include "core/grid/surface.hpp"
#include "io/grid_builder.hpp"
#include "io/physics_builder.hpp"
#include "physics/coupling/bed_stiffness.hpp"
#include "physics/particles/insertion.hpp"
#include "physics/particles/time_step.hpp"
#include <algorithm>
#include <numbers>

namespace io {
namespace {

double mass_of(const Species& s) { return std::numbers::pi / 6 * std::pow(s.diameter, 3) * s.density; }

/// A share of the shortest contact, within what is stable.
double sub_step(const Scene& scene, const physics::ParticleParameters& parameters)
{
    double lightest = std::numeric_limits<double>::infinity();
    for (const Species& s : scene.particles) lightest = std::min(lightest, mass_of(s));
    core::ParticleSet one;
    core::Sphere sphere;
    sphere.density = 1.0;
    sphere.radius = std::cbrt(0.75 * lightest / std::numbers::pi);
    one.add(sphere);
    const physics::StepLimits limits = physics::step_limits(one, parameters);
    return physics::choose_step(limits, limits.contact_time / scene.contact->steps_per_contact);
}

physics::Region region_of(const Initial& initial, const core::Domain& domain)
{
    const core::Vec3 low = initial.low ? core::Vec3(*initial.low - domain.origin) : core::Vec3(core::Vec3::Zero());
    const core::Vec3 high = initial.high ? core::Vec3(*initial.high - domain.origin) : domain.size;
    return {low, high};
}

std::vector<physics::Group> groups_of(const Scene& scene, const core::Domain& domain)
{
    std::vector<physics::Group> groups;
    for (const Species& s : scene.particles) {
        physics::Group group;
        group.like.radius = s.diameter / 2;
        group.like.density = s.density;
        group.like.velocity = s.initial.velocity;
        group.like.species = std::int32_t(groups.size());
        group.count = s.count;
        group.region = region_of(s.initial, domain);
        groups.push_back(group);
    }
    return groups;
}

/// The boundary of the mesh, continued through its periods by more than any particle reaches.
physics::WallSurface wall_surface(const Scene& scene, const core::Mesh& mesh, const core::Domain& domain)
{
    constexpr double smooth_angle = 0.6; // [rad]; a pipe of 12 faces or more is round, the edges of a box are sharp
    double largest = 0;
    for (const Species& s : scene.particles) largest = std::max(largest, s.diameter);
    core::Surface surface = core::boundary_surface(mesh, wall_names(mesh), 2 * largest);
    for (core::Vec3& x : surface.vertices) x -= domain.origin;
    return {surface.vertices, surface.quads, smooth_angle};
}

physics::MagnusLaw magnus_law(MagnusLaw chosen)
{
    switch (chosen) {
    case MagnusLaw::lun_liu: return physics::MagnusLaw::lun_liu;
    case MagnusLaw::rubinow_keller: return physics::MagnusLaw::rubinow_keller;
    case MagnusLaw::seed: return physics::MagnusLaw::tsuji;
    }
    return physics::MagnusLaw::lun_liu;
}

bool wanted(Switch choice, bool otherwise) { return choice == Switch::automatic ? otherwise : choice == Switch::on; }

std::vector<core::Sphere> placed(const Scene& scene, const core::Domain& domain)
{
    const Initial& initial = scene.particles.front().initial;
    const auto groups = groups_of(scene, domain);
    const auto seed = std::uint64_t(scene.run.random_seed);
    switch (initial.arrangement) {
    case Arrangement::random: return physics::place_at_random(domain, primitive_walls(scene.grid), groups, seed);
    case Arrangement::lattice: return physics::place_on_lattice(domain, primitive_walls(scene.grid), groups, seed);
    case Arrangement::packed: return physics::place_packed(domain, groups, initial.spacing, seed);
    }
    return {};
}

} // namespace

physics::ParticleDynamics make_dynamics(const Scene& scene, const core::Mesh& mesh)
{
    const physics::ParticleParameters parameters = particle_parameters(scene);
    const bool faces = scene.contact->walls == WallShape::faces;
    physics::ParticleDynamics dynamics(make_domain(scene.grid), parameters,
                                       faces ? std::vector<physics::Wall>{} : primitive_walls(scene.grid), sub_step(scene, parameters));
    if (faces) dynamics.set_surface(wall_surface(scene, mesh, dynamics.domain()));
    return dynamics;
}

void add_initial_particles(const Scene& scene, const physics::OwnerOf& owner_of, int rank, physics::ParticleDynamics& dynamics)
{
    const auto spheres = placed(scene, dynamics.domain());
    for (const core::Sphere& sphere : spheres)
        if (owner_of(sphere.position) == rank) {
            dynamics.particles.add(sphere);
            dynamics.history.end_row();
        }
}

core::Vec3 settling_gravity(const Scene& scene)
{
    const core::Vec3 gravity = gravity_of(scene);
    if (!scene.fluid) return gravity;
    double mass = 0, volume = 0;
    for (const Species& s : scene.particles) {
        mass += s.count * mass_of(s);
        volume += s.count * mass_of(s) / s.density;
    }
    return (1 - scene.fluid->material.density * volume / mass) * gravity;
}

double bed_stiffness(const Scene& scene, const core::Domain& domain, double grains)
{
    double volume = 0, count = 0, smallest = std::numeric_limits<double>::infinity();
    for (const Species& s : scene.particles) {
        count += s.count;
        volume += s.count * mass_of(s) / s.density;
        smallest = std::min(smallest, s.diameter);
    }
    const double layers = count > 0 ? physics::bed_layers(domain, gravity_of(scene), grains * volume / count, smallest) : 1.0;
    const double normal = scene.contact->stiffness;
    return physics::bed_stiffness(physics::layer_stiffness(normal, scene.contact->tangential_ratio * normal), layers);
}

physics::CouplingParameters coupling_parameters(const Scene& scene)
{
    const Coupling coupling = scene.coupling.value_or(Coupling{});
    const bool seed = coupling.preset == CouplingPreset::seed;
    double lightest_ratio = std::numeric_limits<double>::infinity();
    for (const Species& s : scene.particles) lightest_ratio = std::min(lightest_ratio, s.density / scene.fluid->material.density);
    constexpr double heavy = 150; // above it added mass is below 1 % (NUMERICS E)
    physics::CouplingParameters p;
    p.fluid_density = scene.fluid->material.density;
    p.viscosity = scene.fluid->material.viscosity * p.fluid_density;
    p.gravity = gravity_of(scene);
    p.drag = coupling.chosen_drag() == DragLaw::seed ? physics::DragLaw::kawaguchi : physics::DragLaw::di_felice;
    if (seed) p.force = physics::FluidForce::material_derivative;
    p.magnus = magnus_law(coupling.chosen_magnus());
    p.added_mass = wanted(coupling.added_mass, seed || lightest_ratio < heavy) ? 0.5 : 0.0;
    p.lift = wanted(coupling.lift, seed || lightest_ratio < heavy);
    p.torque = wanted(coupling.torque, true);
    p.filter_width = coupling.filter.in_diameters ? coupling.filter.value * mean_diameter(scene) : coupling.filter.value;
    return p;
}

std::optional<physics::Mode> asked_mode(const Scene& scene)
{
    const CouplingMode mode = scene.coupling.value_or(Coupling{}).mode;
    switch (mode) {
    case CouplingMode::automatic: break;
    case CouplingMode::pipelined: return physics::Mode::pipelined;
    case CouplingMode::coarse: return physics::Mode::coarse;
    case CouplingMode::concurrent: return physics::Mode::concurrent;
    case CouplingMode::iterated: return physics::Mode::iterated;
    }
    return std::nullopt;
}

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/initial_grains.hpp"
#include "core/base/error.hpp"
#include "io/build/grain_census.hpp"
#include "io/build/grid_builder.hpp"
#include "io/run/grain_file.hpp"
#include "io/run/world_walls.hpp"
#include "physics/particles/insertion.hpp"
#include "physics/particles/overlap_relaxation.hpp"
#include <algorithm>

namespace io {
namespace {

using Spheres = std::vector<core::Sphere>;

physics::Group group_of(const Species& s, std::int32_t number, const core::Domain& domain)
{
    physics::Group group;
    if (s.sizes)
        for (const double d : diameters_of(s)) group.radii.push_back(d / 2);
    else group.like.radius = *s.diameter / 2;
    group.like.density = s.density;
    group.like.velocity = s.initial.velocity;
    group.like.species = number;
    group.count = *s.count;
    group.region = s.initial.region.region(domain);
    return group;
}

Spheres placed(const Scene& scene, const core::Domain& domain, const physics::Obstacles& obstacles)
{
    std::vector<physics::Group> groups;
    const Initial* initial = nullptr; // the first that places anything speaks for all
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
        const Species& s = scene.particles[n];
        if (!s.file.empty()) continue;
        if (initial == nullptr) initial = &s.initial;
        groups.push_back(group_of(s, std::int32_t(n), domain));
    }
    if (initial == nullptr) return {};
    const auto seed = std::uint64_t(scene.run.random_seed);
    switch (initial->arrangement) {
    case Arrangement::random: return physics::place_at_random(domain, obstacles, groups, seed);
    case Arrangement::lattice: return physics::place_on_lattice(domain, obstacles, groups, seed);
    case Arrangement::packed: return physics::place_packed(domain, groups, initial->spacing, seed);
    case Arrangement::dense: return physics::place_densely(domain, obstacles, groups, seed);
    }
    return {};
}

/// The particles of species number `species` in its file.
Spheres from_file(const Scene& scene, std::int32_t species, const core::Domain& domain, const core::Communicator& ranks)
{
    const std::string& file = scene.particles[std::size_t(species)].file;
    std::vector<std::string> names;
    for (const Species& s : scene.particles) names.push_back(s.name);
    const bool of_run = is_checkpoint(file);
    Spheres all = of_run ? grains_of_checkpoint(file, ranks) : grains_of_table(file, names);
    std::erase_if(all, [&](const core::Sphere& s) { return s.species != species; });
    core::require<core::ConfigError>(!all.empty(), core::text(file, " has no particles of species '", names[std::size_t(species)], "'"));
    for (core::Sphere& s : all) {
        if (!of_run) s.position -= domain.origin;
        for (int a = 0; a < 3; ++a) s.position[a] = domain.wrapped(a, s.position[a]);
        core::require<core::ConfigError>(
            (s.position.array() >= 0).all() && (s.position.array() <= domain.size.array()).all(),
            core::text(file, ": a particle at ", (s.position + domain.origin).transpose(), " m is outside the domain"));
    }
    return all;
}

/// Pushes particles apart where they overlap, each in the region of its species.
void relax(const Scene& scene, const core::Domain& domain, const std::vector<physics::Wall>& walls, Spheres& all)
{
    std::vector<physics::Region> of_species, regions;
    for (const Species& s : scene.particles) of_species.push_back(s.initial.region.region(domain));
    for (const core::Sphere& s : all) regions.push_back(of_species[std::size_t(s.species)]);
    physics::relax_overlaps(domain, walls, regions, all);
}

} // namespace

Spheres grains_of_files(const Scene& scene, const core::Domain& domain, const core::Communicator& ranks)
{
    Spheres all;
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
        if (scene.particles[n].file.empty()) continue;
        const Spheres more = from_file(scene, std::int32_t(n), domain, ranks);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

Spheres initial_grains(const Scene& scene, const Spheres& of_files, const physics::ParticleDynamics& dynamics)
{
    const core::Domain& domain = dynamics.domain();
    const physics::Obstacles obstacles = obstacles_of(walls_at_start(scene, domain), dynamics);
    Spheres all = placed(scene, domain, obstacles);
    const bool mixed = !all.empty() && !of_files.empty(); // what is placed knows nothing of what files bring
    const bool asked =
        std::any_of(scene.particles.begin(), scene.particles.end(), [](const Species& s) { return s.initial.overlaps == Overlaps::relax; });
    all.insert(all.end(), of_files.begin(), of_files.end());
    if (asked || mixed) relax(scene, domain, obstacles.walls, all);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.species < b.species; });
    for (std::size_t n = 0; n < all.size(); ++n) all[n].id = std::int64_t(n);
    return all;
}

} // namespace io

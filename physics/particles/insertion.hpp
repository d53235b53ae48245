// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Places for new particles: at random or on a lattice, apart from each other and from the walls. Every rank finds the same
// places, since each number comes from the seed and the particle's id.
#include "core/particles/particle_set.hpp"
#include "physics/particles/obstacles.hpp"
#include "physics/particles/region.hpp"

#include <cstdint>

namespace physics {

/// A group of particles to be placed, equal but for their sizes.
struct Group {
    core::Sphere like; ///< all but position and id
    int count = 0;
    std::vector<double> radii; ///< One for each, dealt out at random; without them all have that of `like` [m].
    Region region;             ///< Of the centres.
};

/// Random sequential addition, the largest spheres first; ids run through the groups in their order.
/// @throws core::ConfigError if some sphere finds no place: the region is too full.
[[nodiscard]] std::vector<core::Sphere> place_at_random(const core::Domain& domain, const Obstacles& obstacles,
                                                        const std::vector<Group>& groups, std::uint64_t seed);

/// Anywhere at random, then relaxed until none overlaps (overlap_relaxation.hpp), where walls alone hold them: up to random close packing.
/// @throws core::ConfigError if they do not come apart: the region is too full.
[[nodiscard]] std::vector<core::Sphere> place_densely(const core::Domain& domain, const Obstacles& obstacles,
                                                      const std::vector<Group>& groups, std::uint64_t seed);

/// A simple cubic lattice just wider than the largest sphere, filled from below, the groups mixed at random.
/// @throws core::ConfigError if the regions have too few sites.
[[nodiscard]] std::vector<core::Sphere> place_on_lattice(const core::Domain& domain, const Obstacles& obstacles,
                                                         const std::vector<Group>& groups, std::uint64_t seed);

/// Face-centred cubes: whole ones along periodic axes; along others layers from wall to wall, so near to the walls that these push as
/// hard as four neighbours do. Filled from the low end of the first axis that is not periodic, the groups mixed at random.
/// @param spacing  Distance of neighbours in largest diameters, as near as whole cubes fit; below 1 they overlap.
/// @throws core::ConfigError if the regions have too few sites.
[[nodiscard]] std::vector<core::Sphere> place_packed(const core::Domain& domain, const std::vector<Group>& groups, double spacing,
                                                     std::uint64_t seed);

} // namespace physics

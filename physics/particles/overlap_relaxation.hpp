// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Spheres that overlap are pushed apart until none does: random close packings, and beds from elsewhere that do not quite fit.
#include "core/particles/particle_set.hpp"
#include "physics/particles/region.hpp"
#include "physics/particles/walls.hpp"

namespace physics {

struct Relaxation {
    int sweeps = 0;           ///< Steps it took.
    double farthest_move = 0; ///< Of a sphere from its first place [m].
};

/// Lowers the energy of overlaps, springs of equal stiffness between spheres and at walls, until no two spheres and no sphere and wall
/// overlap, each staying in its region. In a step no sphere moves by more than a tenth of its diameter. Periodic axes are open to the
/// spheres whose region is as long as the domain. Serial: every rank comes to the same places.
/// @param regions  One for each sphere.
/// @throws core::ConfigError if overlaps are left after many sweeps: the region is too full.
/// @source  Bitzek et al. (2006), Phys. Rev. Lett. 97, 170201 (FIRE); the quench is that of O'Hern et al. (2003), Phys. Rev. E 68, 011306.
Relaxation relax_overlaps(const core::Domain& domain, const std::vector<Wall>& walls, const std::vector<Region>& regions,
                          std::vector<core::Sphere>& spheres);

} // namespace physics

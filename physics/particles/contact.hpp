// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Forces of touching pairs, first pair by pair, then summed for each particle in the order of its neighbours' ids.
#include "core/particles/near_pairs.hpp"
#include "physics/particles/contact_law.hpp"
#include "physics/particles/motion_records.hpp"

#include <span>

namespace physics {

/// Force on the first particle [N]; normal x force, which times each lever arm is the torque on that particle.
struct alignas(64) ContactForce {
    double force[4];  ///< Fourth: distance from the first centre to the contact point [m].
    double torque[4]; ///< [N]; fourth: distance from the second centre.
};

/// The laws of all pairs of species; law of near pair m: entry kind[m], or the only one.
using ContactLaws = std::vector<LinearContact>;

/// The laws of `parameters.pairs`, species x species. @throws core::ConfigError for a wrong number of entries.
[[nodiscard]] ContactLaws pair_laws(const ParticleParameters& parameters, double step);
/// The laws of `parameters.walls`, one for each species.
[[nodiscard]] ContactLaws wall_laws(const ParticleParameters& parameters, double step);

/// What the force of a pair depends on.
struct PairScene {
    const core::ParticleSet& particles;
    const MotionRecords& records;
    const core::PairList& pairs;
    const std::array<core::Vec3, 27>& shifts;
    const ContactLaws& laws;
    std::uint64_t seed;
};

/// Forces of the near pairs of `chunk`; moves their springs one step on.
/// @param[out] forces  One place for each pair of the pair list.
void pair_forces(const PairScene& scene, core::NearPairs& near, int chunk, std::span<ContactForce> forces);

} // namespace physics

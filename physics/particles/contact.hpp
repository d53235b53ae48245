// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Forces of touching pairs, first pair by pair, then summed for each particle in the order of its neighbours' ids.
#include "core/particles/near_pairs.hpp"
#include "physics/particles/contact_books.hpp"
#include "physics/particles/contact_laws.hpp"
#include "physics/particles/motion_records.hpp"

namespace physics {

/// Force on the first particle, normal x force, and lever arms, which times the latter are the torques on the two particles.
struct alignas(64) ContactForce {
    double values[8]; ///< Force [N], first lever arm [m], normal x force [N], second lever arm [m].

    [[nodiscard]] const double* force() const { return values; }
    [[nodiscard]] const double* torque() const { return values + 4; }
    /// From the centre of the first (0) or second particle (1) to the contact point [m].
    [[nodiscard]] double lever(std::size_t side) const { return values[3 + 4 * side]; }
};

/// Torque on the first particle; the second receives the opposite [N m].
struct alignas(32) ContactCouple {
    double torque[4]; ///< The fourth is not used.
};

/// The energy of a pair's contact, and normal x force of its dashpots, which times each lever arm is their torque.
struct PairBook {
    ContactBook book;
    double torque[3]; ///< [N]
};

/// What the contacts of pairs do, slot by slot (core::PairSlots).
struct PairForces {
    std::vector<ContactForce> forces;
    std::vector<ContactCouple> couples; ///< Empty where contacts do not resist turning.
    std::vector<PairBook> books;        ///< Empty where no budget is kept.
    void resize(std::size_t slots, const ContactLaws& laws, Budget budget)
    {
        forces.resize(slots);
        couples.resize(resist_turning(laws) ? slots : 0);
        books.resize(budget == Budget::kept ? slots : 0);
    }
};

/// What the force of a pair depends on.
struct PairScene {
    const core::ParticleSet& particles;
    MotionRecords::View records;
    const core::PairList& pairs;
    const core::PairSlots& slots;
    const std::array<core::Vec3, 27>& shifts;
    const ContactLaws& laws;
    std::uint64_t seed;
};

/// Forces of the near pairs of `chunk`; moves their springs one step on.
void pair_forces(const PairScene& scene, core::NearPairs& near, int chunk, PairForces& forces);

} // namespace physics

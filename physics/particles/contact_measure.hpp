// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the contacts between particles come to for each of them: their number, and their share of the stress.
#include "physics/particles/contact.hpp"

namespace physics {

/// Columns of the particles, set at the end of a batch of sub-steps.
struct ContactColumns {
    int coordination;      ///< Contacts with other particles that push [-].
    int wall_coordination; ///< Contacts with walls that push [-].
    /// First of six, xx yy zz yz zx xy: the stress_share() of all contacts, with walls, too; over a volume a stress [J].
    int stress;
};

/// What a contact adds to the stress of a particle, xx yy zz yz zx xy: minus the symmetric part of arm x force, positive under
/// pressure [J].
/// @source  Love (1927); Weber (1966): the mean stress of a volume is the sum over contacts of force and branch.
[[nodiscard]] inline std::array<double, 6> stress_share(const core::Vec3& force, const core::Vec3& arm)
{
    const auto mixed = [&](int a, int b) { return -0.5 * (arm[a] * force[b] + arm[b] * force[a]); };
    return {mixed(0, 0), mixed(1, 1), mixed(2, 2), mixed(1, 2), mixed(2, 0), mixed(0, 1)};
}

[[nodiscard]] ContactColumns add_contact_columns(core::ParticleSet& particles);

/// What walls come to for the particles of one chunk in the last sub-step; entry k belongs to owned particle begin + k.
struct WallShares {
    using Lane = std::array<double, core::particles_per_chunk>;
    Lane contacts{};              ///< That push [-].
    std::array<Lane, 6> stress{}; ///< [J]

    /// @param force  On the particle [N]. @param arm  From its centre to the wall [m].
    /// @param radius  Of the particle: from farther away a film acts, which is no contact [m].
    void add(std::size_t k, const core::Vec3& force, const core::Vec3& arm, double radius)
    {
        if (force.isZero(0.0)) return;
        contacts[k] += double(arm.squaredNorm() <= radius * radius);
        const auto share = stress_share(force, arm);
        for (std::size_t n = 0; n < share.size(); ++n) stress[n][k] += share[n];
    }
};

/// Sets the columns of owned particles [begin, end) to what walls come to.
void measure_walls(core::ParticleSet& particles, const WallShares& shares, int begin, int end, const ContactColumns& columns);

/// Adds the contacts of pairs in the last sub-step to the columns of the owned particles, which hold those with walls.
void measure_contacts(core::ParticleSet& particles, const core::PairList& pairs, const core::NearPairs& near,
                      const std::array<core::Vec3, 27>& shifts, const PairForces& forces, const ContactColumns& columns,
                      const core::Team& team);

/// Sets the columns where there is no contact at all.
void measure_no_contacts(core::ParticleSet& particles, const ContactColumns& columns);

} // namespace physics

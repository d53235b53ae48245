// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the contacts between particles come to for each of them: their number, and their share of the stress.
#include "physics/particles/contact.hpp"

namespace physics {

/// Columns of the particles, set at the end of a batch of sub-steps. Contacts with walls are not among them.
struct ContactColumns {
    int coordination; ///< Contacts that push [-].
    /// First of six, xx yy zz yz zx xy: minus the symmetric part of the sum of lever arm x force; over a volume a stress, positive under
    /// pressure [J].
    int stress;
};

[[nodiscard]] ContactColumns add_contact_columns(core::ParticleSet& particles);

/// Sets the columns of the owned particles from the forces of the last sub-step.
/// @source  Love (1927); Weber (1966): the mean stress of a volume is the sum over contacts of force and branch.
void measure_contacts(core::ParticleSet& particles, const core::PairList& pairs, const core::NearPairs& near,
                      const std::array<core::Vec3, 27>& shifts, const PairForces& forces, const ContactColumns& columns,
                      const core::Team& team);

/// The same without any contact.
void measure_no_contacts(core::ParticleSet& particles, const ContactColumns& columns);

} // namespace physics

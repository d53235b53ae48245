// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact_measure.hpp"

namespace physics {
namespace {

constexpr int components = 6;

} // namespace

ContactColumns add_contact_columns(core::ParticleSet& particles)
{
    ContactColumns columns{particles.add_column(), 0};
    columns.stress = particles.add_column();
    for (int n = 1; n < components; ++n) (void)particles.add_column();
    return columns;
}

void measure_contacts(core::ParticleSet& particles, const core::PairList& pairs, const core::NearPairs& near,
                      const std::array<core::Vec3, 27>& shifts, const PairForces& forces, const ContactColumns& columns,
                      const core::Team& team)
{
    const auto measure = [&](std::size_t i) {
        std::array<double, components> stress{};
        int contacts = 0;
        for (auto k = std::size_t(pairs.row_begin[i]); k < std::size_t(near.row_end[i]); ++k) {
            const auto m = std::size_t(near.row[k] >> 1);
            const auto side = std::size_t(near.row[k] & 1);
            const ContactForce& contact = forces.forces[m];
            const core::Vec3 on_first(contact.force()[0], contact.force()[1], contact.force()[2]);
            if (on_first.isZero(0.0)) continue;
            const core::Vec3 way = particles.position_of(pairs.second[m]) - particles.position_of(pairs.first[m]) + shifts[pairs.image[m]];
            // Both the force and the way to the contact turn round for the second.
            const core::Vec3 arm = contact.lever(side) * way.normalized();
            const core::Vec3 yz_zx_xy =
                0.5 * core::Vec3(arm.y() * on_first.z() + arm.z() * on_first.y(), arm.z() * on_first.x() + arm.x() * on_first.z(),
                                 arm.x() * on_first.y() + arm.y() * on_first.x());
            for (std::size_t a = 0; a < 3; ++a) {
                stress[a] -= arm[int(a)] * on_first[int(a)];
                stress[3 + a] -= yz_zx_xy[int(a)];
            }
            contacts += int(contact.lever(side) <= particles.radius[i]); // beyond it a film acts
        }
        particles.columns[std::size_t(columns.coordination)][i] = contacts;
        for (std::size_t n = 0; n < components; ++n) particles.columns[std::size_t(columns.stress) + n][i] = stress[n];
    };
    core::for_chunks(team, particles.owned, core::particles_per_chunk, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) measure(std::size_t(i));
    });
}

void measure_no_contacts(core::ParticleSet& particles, const ContactColumns& columns)
{
    for (int n = 0; n < components; ++n) {
        auto& column = particles.columns[std::size_t(columns.stress + n)];
        std::fill(column.begin(), column.end(), 0.0);
    }
    auto& count = particles.columns[std::size_t(columns.coordination)];
    std::fill(count.begin(), count.end(), 0.0);
}

} // namespace physics

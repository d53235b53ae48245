// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact_measure.hpp"

namespace physics {
namespace {

constexpr std::size_t components = 6;

core::Column& column(core::ParticleSet& particles, int number, std::size_t component = 0)
{
    return particles.columns[std::size_t(number) + component];
}

} // namespace

ContactColumns add_contact_columns(core::ParticleSet& particles)
{
    ContactColumns columns{particles.add_column(), particles.add_column(), particles.add_column()};
    for (std::size_t n = 1; n < components; ++n) (void)particles.add_column();
    return columns;
}

void measure_walls(core::ParticleSet& particles, const WallShares& shares, int begin, int end, const ContactColumns& columns)
{
    const auto set = [&](const WallShares::Lane& values, core::Column& of_all) {
        std::copy_n(values.begin(), end - begin, of_all.begin() + begin);
    };
    set(shares.contacts, column(particles, columns.wall_coordination));
    for (std::size_t n = 0; n < components; ++n) set(shares.stress[n], column(particles, columns.stress, n));
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
            const auto share = stress_share(on_first, contact.lever(side) * way.normalized());
            for (std::size_t n = 0; n < components; ++n) stress[n] += share[n];
            contacts += int(contact.lever(side) <= particles.radius[i]); // beyond it a film acts
        }
        column(particles, columns.coordination)[i] = contacts;
        for (std::size_t n = 0; n < components; ++n) column(particles, columns.stress, n)[i] += stress[n];
    };
    core::for_chunks(team, particles.owned, core::particles_per_chunk, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) measure(std::size_t(i));
    });
}

void measure_no_contacts(core::ParticleSet& particles, const ContactColumns& columns)
{
    const auto clear = [](core::Column& values) { std::fill(values.begin(), values.end(), 0.0); };
    clear(column(particles, columns.coordination));
    clear(column(particles, columns.wall_coordination));
    for (std::size_t n = 0; n < components; ++n) clear(column(particles, columns.stress, n));
}

} // namespace physics

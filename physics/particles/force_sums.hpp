// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Forces and torques on the particles of one chunk, summed in a fixed order.
#include "core/base/four.hpp"
#include "physics/particles/contact.hpp"

namespace physics {

/// Entry k belongs to owned particle begin + k.
struct alignas(64) ForceSums {
    using Lane = std::array<double, core::particles_per_chunk>;
    std::array<Lane, 3> force;  ///< [N]
    std::array<Lane, 3> torque; ///< [N m]
    int begin = 0, end = 0;
};

/// Sums the pair forces of each particle of the chunk in the order of its neighbours' ids. Nothing here branches on what cannot be
/// foreseen: which of a pair a particle is, and, particles with as many near pairs being done one after the other, how many it has.
inline void sum_pair_forces(const core::PairList& pairs, const core::NearPairs& near, const PairForces& all, ForceSums& sums)
{
    constexpr double signs[] = {1.0, -1.0};
    const ContactForce* forces = all.forces.data();
    const int *row = near.row.data(), *row_begin = pairs.row_begin.data() + sums.begin, *row_end = near.row_end.data() + sums.begin;
    const std::uint8_t* order = near.order.data() + sums.begin;
    for (int n = 0; n < sums.end - sums.begin; ++n) {
        const std::size_t k = order[n];
        core::Four force{}, torque{};
        for (int entry = row_begin[k]; entry < row_end[k]; ++entry) {
            const auto place = std::size_t(row[entry]);
            const ContactForce& contact = forces[place >> 1];
            force += signs[place & 1] * core::load_four(contact.force());
            torque += contact.lever(place & 1) * core::load_four(contact.torque());
        }
        for (std::size_t a = 0; a < 3; ++a) {
            sums.force[a][k] = force[int(a)];
            sums.torque[a][k] = torque[int(a)];
        }
    }
}

/// Adds the pairs' torques against turning in the same order.
inline void add_pair_couples(const core::PairList& pairs, const core::NearPairs& near, const PairForces& all, ForceSums& sums)
{
    for (int i = sums.begin; i < sums.end; ++i) {
        core::Four torque{};
        for (int k = pairs.row_begin[std::size_t(i)]; k < near.row_end[std::size_t(i)]; ++k) {
            const int entry = near.row[std::size_t(k)];
            const double sign = (entry & 1) != 0 ? -1.0 : 1.0;
            torque += sign * core::load_four(all.couples[std::size_t(entry >> 1)].torque);
        }
        for (std::size_t a = 0; a < 3; ++a) sums.torque[a][std::size_t(i - sums.begin)] += torque[int(a)];
    }
}

} // namespace physics

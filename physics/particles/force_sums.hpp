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

/// Sums the pair forces of each particle of `chunk` in the order of its neighbours' ids.
inline void sum_pair_forces(const core::PairList& pairs, const core::NearPairs& near, const PairForces& all, ForceSums& sums)
{
    const auto& forces = all.forces;
    for (int i = sums.begin; i < sums.end; ++i) {
        core::Four force{}, torque{};
        for (int k = pairs.row_begin[std::size_t(i)]; k < near.row_end[std::size_t(i)]; ++k) {
            const int entry = near.row[std::size_t(k)];
            const ContactForce& contact = forces[std::size_t(entry >> 1)];
            const bool is_second = (entry & 1) != 0;
            const double sign = is_second ? -1.0 : 1.0, lever = is_second ? contact.torque[3] : contact.force[3];
            force += sign * core::load_four(contact.force);
            torque += lever * core::load_four(contact.torque);
        }
        const auto k = std::size_t(i - sums.begin);
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

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What particles do to a wall, summed over contacts and sub-steps without rounding: the same bits for any ranks and threads.
#include "core/base/exact_sum.hpp"
#include "core/base/vec3.hpp"

#include <span>

namespace physics {

/// What one contact does to the particle.
struct WallPush {
    core::Vec3 force = core::Vec3::Zero();  ///< [N]
    core::Vec3 couple = core::Vec3::Zero(); ///< Torque beside that of the force [N m].
    core::Vec3 arm = core::Vec3::Zero();    ///< From the wall's point of reference to where they touch [m].
    double power = 0.0;                     ///< That the wall gives to the particle [W].
};

/// Sums over all contacts of a wall.
struct WallLoad {
    static constexpr std::size_t size = 7;
    /// Force on the wall [N], torque on it [N m], power that it gives to the particles [W].
    std::array<core::ExactSum, size> sum;

    void add(const WallPush& push)
    {
        const core::Vec3 torque = push.arm.cross(push.force) + push.couple;
        for (std::size_t a = 0; a < 3; ++a) {
            sum[a].add(-push.force[int(a)]);
            sum[3 + a].add(-torque[int(a)]);
        }
        sum[6].add(push.power);
    }
    void add(const WallLoad& other)
    {
        for (std::size_t n = 0; n < size; ++n) sum[n].add(other.sum[n]);
    }
};

/// One for each wall that is reported.
using WallLoads = std::span<WallLoad>;

} // namespace physics

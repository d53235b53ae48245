// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What new particles keep clear of.
#include "physics/particles/wall_distance.hpp"

#include <functional>

namespace physics {

struct Obstacles {
    std::vector<Wall> walls;
    /// Whether anything else is in the way of a sphere; may be empty.
    std::function<bool(const core::Vec3& centre, double radius)> block = {};

    [[nodiscard]] bool leave_room(const core::Vec3& centre, double radius) const
    {
        return clearance(walls, centre, radius) >= 0.0 && !(block && block(centre, radius));
    }
};

} // namespace physics

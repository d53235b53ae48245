// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far points are from plane and cylindrical walls.
#include "physics/particles/walls.hpp"

namespace physics {

struct WallDistance {
    double distance;   ///< Negative behind the wall [m].
    core::Vec3 inward; ///< Unit vector away from the wall.
};

[[nodiscard]] WallDistance distance_from(const PlaneWall& wall, const core::Vec3& x);
/// On the axis of a cylinder `inward` is zero.
[[nodiscard]] WallDistance distance_from(const CylinderWall& wall, const core::Vec3& x);

/// Distance from the surface of a sphere to the nearest wall; negative if it sticks in a wall [m].
[[nodiscard]] double clearance(const std::vector<Wall>& walls, const core::Vec3& centre, double radius);

} // namespace physics

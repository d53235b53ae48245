// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/wall_distance.hpp"

#include <algorithm>
#include <limits>

namespace physics {

WallDistance distance_from(const PlaneWall& wall, const core::Vec3& x)
{
    const core::Vec3 normal = wall.normal.normalized();
    return {(x - wall.point).dot(normal), normal};
}

WallDistance distance_from(const CylinderWall& wall, const core::Vec3& x)
{
    const core::Vec3 axis = wall.axis.normalized(), from = x - wall.point;
    const core::Vec3 across = from - from.dot(axis) * axis;
    const double r = across.norm();
    const double side = wall.particles == WallSide::inside ? 1.0 : -1.0;
    return {side * (wall.radius - r), r > 0 ? core::Vec3(-side * across / r) : core::Vec3(core::Vec3::Zero())};
}

double clearance(const std::vector<Wall>& walls, const core::Vec3& centre, double radius)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls)
        nearest = std::min(nearest, std::visit([&](const auto& w) { return distance_from(w, centre).distance; }, wall));
    return nearest - radius;
}

} // namespace physics

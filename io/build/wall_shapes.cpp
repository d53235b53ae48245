// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/wall_shapes.hpp"
#include "io/files/stl.hpp"
#include <cmath>
#include <numbers>

namespace io {
namespace {

using core::Vec3;
using Triangles = std::vector<std::array<Vec3, 3>>;

constexpr int around = 96; // their bent triangles are then off the circle by less than a millionth of its radius

/// Points of a circle about an axis.
class Circle {
public:
    explicit Circle(const Vec3& axis) : one_(axis.normalized().unitOrthogonal()), two_(axis.normalized().cross(one_)) {}
    [[nodiscard]] Vec3 at(int n) const
    {
        const double angle = 2 * std::numbers::pi * (n % around) / around;
        return std::cos(angle) * one_ + std::sin(angle) * two_;
    }

private:
    Vec3 one_, two_;
};

Triangles ring(const Circle& circle, const Vec3& from, double radius, const Vec3& to, double end_radius)
{
    Triangles triangles;
    for (int n = 0; n < around; ++n) {
        const Vec3 a = from + radius * circle.at(n), b = from + radius * circle.at(n + 1);
        const Vec3 c = to + end_radius * circle.at(n + 1), d = to + end_radius * circle.at(n);
        if (radius > 0) triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return triangles;
}

} // namespace

Triangles triangles_of(const WallKeys& wall)
{
    if (const auto& t = wall.tube) return ring(Circle(t->to - t->from), t->from, t->radius, t->to, t->end_radius.value_or(t->radius));
    if (const auto& d = wall.disc) return ring(Circle(d->normal), d->point, d->hole, d->point, d->radius);
    Triangles triangles;
    if (!wall.stl) return triangles;
    triangles = read_stl(wall.stl->file);
    for (auto& corners : triangles)
        for (Vec3& x : corners) x = wall.stl->unit * x + wall.stl->at;
    return triangles;
}

double smooth_angle_of(const WallKeys& wall)
{
    constexpr double round = 0.2; // [rad]; a tube's neighbours meet at 0.065
    return wall.stl ? wall.stl->smooth_angle : round;
}

Vec3 point_of(const WallKeys& wall)
{
    if (wall.plane) return wall.plane->point;
    if (wall.cylinder) return wall.cylinder->point;
    if (wall.tube) return wall.tube->from;
    if (wall.disc) return wall.disc->point;
    return wall.stl ? wall.stl->at : Vec3(Vec3::Zero());
}

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/region.hpp"

#include <algorithm>
#include <numbers>

namespace physics {
namespace {

using core::Vec3;

/// A point seen from a cylinder: its way along the axis, and what is left across.
struct Split {
    double along; ///< [m]
    Vec3 across;  ///< [m]
};

Split split(const CylinderRegion& cylinder, const Vec3& x)
{
    const Vec3 axis = (cylinder.to - cylinder.from).normalized(), from = x - cylinder.from;
    const double along = from.dot(axis);
    return {along, from - along * axis};
}

Vec3 shortened(const Vec3& v, double length)
{
    const double norm = v.norm();
    return norm > length ? Vec3(length / norm * v) : v;
}

Vec3 nearest(const BoxRegion& box, const Vec3& x) { return x.cwiseMax(box.low).cwiseMin(box.high); }

Vec3 nearest(const CylinderRegion& cylinder, const Vec3& x)
{
    const Vec3 axis = cylinder.to - cylinder.from;
    const auto [along, across] = split(cylinder, x);
    return cylinder.from + std::clamp(along, 0.0, axis.norm()) * axis.normalized() + shortened(across, cylinder.radius);
}

Vec3 nearest(const SphereRegion& sphere, const Vec3& x) { return sphere.centre + shortened(x - sphere.centre, sphere.radius); }

bool has(const BoxRegion& box, const Vec3& x) { return (x.array() >= box.low.array()).all() && (x.array() <= box.high.array()).all(); }

bool has(const CylinderRegion& cylinder, const Vec3& x)
{
    const auto [along, across] = split(cylinder, x);
    return along >= 0 && along <= (cylinder.to - cylinder.from).norm() && across.norm() <= cylinder.radius;
}

bool has(const SphereRegion& sphere, const Vec3& x) { return (x - sphere.centre).norm() <= sphere.radius; }

Vec3 point(const BoxRegion& box, const Vec3& u) { return box.low + u.cwiseProduct(box.high - box.low); }

Vec3 point(const CylinderRegion& cylinder, const Vec3& u)
{
    const Vec3 axis = (cylinder.to - cylinder.from).normalized();
    const Vec3 side = axis.unitOrthogonal(), other = axis.cross(side);
    const double r = cylinder.radius * std::sqrt(u[1]), angle = 2 * std::numbers::pi * u[2];
    return cylinder.from + u[0] * (cylinder.to - cylinder.from) + r * std::cos(angle) * side + r * std::sin(angle) * other;
}

Vec3 point(const SphereRegion& sphere, const Vec3& u)
{
    const double r = sphere.radius * std::cbrt(u[0]), z = 2 * u[1] - 1, angle = 2 * std::numbers::pi * u[2];
    const double across = std::sqrt(std::max(0.0, 1 - z * z));
    return sphere.centre + r * Vec3(across * std::cos(angle), across * std::sin(angle), z);
}

Region wider(const BoxRegion& box, double by) { return BoxRegion{box.low - Vec3::Constant(by), box.high + Vec3::Constant(by)}; }

Region wider(const CylinderRegion& cylinder, double by)
{
    const Vec3 axis = (cylinder.to - cylinder.from).normalized();
    return CylinderRegion{cylinder.from - by * axis, cylinder.to + by * axis, cylinder.radius + by};
}

Region wider(const SphereRegion& sphere, double by) { return SphereRegion{sphere.centre, sphere.radius + by}; }

double volume(const BoxRegion& box) { return (box.high - box.low).prod(); }

double volume(const CylinderRegion& cylinder)
{
    return std::numbers::pi * cylinder.radius * cylinder.radius * (cylinder.to - cylinder.from).norm();
}

double volume(const SphereRegion& sphere) { return 4.0 / 3.0 * std::numbers::pi * std::pow(sphere.radius, 3); }

} // namespace

bool contains(const Region& region, const Vec3& x)
{
    return std::visit([&](const auto& r) { return has(r, x); }, region);
}

Vec3 nearest_point(const Region& region, const Vec3& x)
{
    return std::visit([&](const auto& r) { return nearest(r, x); }, region);
}

Vec3 point_in(const Region& region, const Vec3& uniform)
{
    return std::visit([&](const auto& r) { return point(r, uniform); }, region);
}

Region grown(const Region& region, double distance)
{
    return std::visit([&](const auto& r) { return wider(r, distance); }, region);
}

double volume_of(const Region& region)
{
    return std::visit([](const auto& r) { return volume(r); }, region);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/surface_side.hpp"
#include "core/base/error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using core::Vec3;

int sign_of(double x) { return (x > 0.0) - (x < 0.0); }

/// What stands upright in a drawing leans here: seen from above, no face is a line, which rounding would not leave straight.
Vec3 tilted(const Vec3& x)
{
    static const core::Mat3 tilt = Eigen::AngleAxisd(0.83, Vec3(0.41, 0.67, 0.23).normalized()).toRotationMatrix();
    return tilt * x;
}

} // namespace

SurfaceSide::SurfaceSide(TriangleMesh mesh, WallSide particles) : mesh_(std::move(mesh)), particles_(particles)
{
    const auto rim = rim_of(mesh_);
    core::require<core::ConfigError>(
        !rim, rim ? core::text("the surface is open at (", rim->transpose(), ") m: only a closed one has an inside") : "");
    for (Vec3& x : mesh_.vertices) x = tilted(x);
    low_ = high_ = mesh_.vertices.front();
    for (const Vec3& x : mesh_.vertices) {
        low_ = low_.cwiseMin(x);
        high_ = high_.cwiseMax(x);
    }
    bins_ = std::clamp(int(std::sqrt(double(mesh_.triangles.size()))), 1, 1000);
    above_.resize(std::size_t(bins_ * bins_));
    for (int t = 0; t < int(mesh_.triangles.size()); ++t) {
        Vec3 low = high_, high = low_;
        for (const int v : mesh_.triangles[std::size_t(t)]) {
            low = low.cwiseMin(mesh_.vertices[std::size_t(v)]);
            high = high.cwiseMax(mesh_.vertices[std::size_t(v)]);
        }
        for (int i = bin(0, low[0]); i <= bin(0, high[0]); ++i)
            for (int j = bin(1, low[1]); j <= bin(1, high[1]); ++j) above_[std::size_t(i * bins_ + j)].push_back(t);
    }
}

int SurfaceSide::bin(int axis, double at) const
{
    const double share = (at - low_[axis]) / std::max(high_[axis] - low_[axis], 1e-300);
    return std::clamp(int(share * bins_), 0, bins_ - 1);
}

/// On which side of an edge the place lies, seen from above: the same bits from both triangles that share it. A place just on it is
/// taken to lie a little further along x and much less along y, so that no ray passes between two triangles or through both.
/// @source  Edelsbrunner and Mücke (1990), Simulation of simplicity.
int SurfaceSide::turn(const Vec3& x, int from, int to) const
{
    const Vec3 &a = mesh_.vertices[std::size_t(std::min(from, to))], &b = mesh_.vertices[std::size_t(std::max(from, to))];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double area = dx * (x[1] - a[1]) - dy * (x[0] - a[0]);
    const int side = area != 0.0 ? sign_of(area) : dy != 0.0 ? sign_of(-dy) : sign_of(dx);
    return from < to ? side : -side;
}

bool SurfaceSide::is_below(const Vec3& x, const std::array<int, 3>& t) const
{
    const int first = turn(x, t[0], t[1]);
    if (first == 0 || turn(x, t[1], t[2]) != first || turn(x, t[2], t[0]) != first) return false;
    const Vec3& a = mesh_.vertices[std::size_t(t[0])];
    const Vec3 normal = (mesh_.vertices[std::size_t(t[1])] - a).cross(mesh_.vertices[std::size_t(t[2])] - a);
    return (a - x).dot(normal) * normal[2] > 0.0;
}

bool SurfaceSide::holds(const Vec3& place) const
{
    const Vec3 x = tilted(place);
    bool inside = false;
    if ((x.array() >= low_.array()).all() && (x.array() <= high_.array()).all())
        for (const int t : above_[std::size_t(bin(0, x[0]) * bins_ + bin(1, x[1]))])
            if (is_below(x, mesh_.triangles[std::size_t(t)])) inside = !inside;
    return inside == (particles_ == WallSide::inside);
}

} // namespace physics

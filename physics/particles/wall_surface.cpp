// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/wall_surface.hpp"
#include "core/base/error.hpp"
#include "physics/particles/wall_faces.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using core::Vec3;

// A foot this far outside a triangle, in barycentric coordinates, still counts: neighbours overlap a little, and of two hits with
// one normal only the deeper is kept.
constexpr double overlap_share = 1e-3;

/// Middle bend of the curve between two points with normals m and n: it leaves both at right angles to the normal.
Vec3 bend_of(const Vec3& a, const Vec3& m, const Vec3& b, const Vec3& n)
{
    const Vec3 chord = b - a;
    return (m + n) * ((chord.dot(n) - chord.dot(m)) / (2.0 * (1.0 + m.dot(n))));
}

} // namespace

WallSurface::WallSurface(std::span<const Vec3> vertices, std::span<const std::array<int, 4>> quads, double smooth_angle)
{
    const WallFaces faces(vertices, quads, smooth_angle);
    spokes_ = faces.spokes();
    for (int f = 0; f < int(quads.size()); ++f) add_triangles(faces, f);
    fill_bins();
}

void WallSurface::add_triangles(const WallFaces& faces, int face)
{
    std::array<Vec3, 4> corner, normal;
    Vec3 mean = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
        corner[std::size_t(k)] = faces.corner(face, k);
        normal[std::size_t(k)] = faces.corner_normal(face, k);
        mean += normal[std::size_t(k)];
    }
    mean.normalize();
    const Vec3 centre = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]) +
                        0.125 * (bend_of(corner[0], normal[0], corner[2], normal[2]) + bend_of(corner[1], normal[1], corner[3], normal[3]));
    for (int k = 0; k < 4; ++k) {
        const auto a = std::size_t(k), b = std::size_t((k + 1) % 4);
        if ((corner[b] - corner[a]).norm() == 0.0) continue; // a face with three corners
        Triangle t;
        t.corner = {centre, corner[a], corner[b]};
        t.normal = {mean, normal[a], normal[b]};
        for (std::size_t e = 0; e < 3; ++e) {
            const auto i = (e + 1) % 3, j = (e + 2) % 3;
            t.bend[e] = bend_of(t.corner[i], t.normal[i], t.corner[j], t.normal[j]);
            t.flat = t.flat && t.bend[e].norm() < 1e-12 * (t.corner[j] - t.corner[i]).norm();
        }
        const Vec3 one = t.corner[1] - t.corner[0], two = t.corner[2] - t.corner[0], up = one.cross(two);
        t.dual_one = two.cross(up) / up.squaredNorm();
        t.dual_two = up.cross(one) / up.squaredNorm();
        t.sharp[0] = faces.sharp(face, k);
        t.across[0] = faces.across(face, k);
        t.across[1] = t.across[2] = Vec3::Zero();
        t.vertex = {-1, faces.sharp_vertex(face, k), faces.sharp_vertex(face, (k + 1) % 4)};
        triangles_.push_back(t);
    }
}

WallSurface::Foot WallSurface::foot(const Triangle& t, const Vec3& centre)
{
    Foot f;
    const Vec3 from = centre - t.corner[0];
    double one = t.dual_one.dot(from), two = t.dual_two.dot(from);
    const int rounds = t.flat ? 1 : 6; // each round divides the error by radius of curvature over depth
    for (int round = 0; round < rounds; ++round) {
        const double zero = 1.0 - one - two;
        f.weight = {zero, one, two};
        f.point = zero * t.corner[0] + one * t.corner[1] + two * t.corner[2] + (one * two) * t.bend[0] + (zero * two) * t.bend[1] +
                  (zero * one) * t.bend[2];
        f.normal = (zero * t.normal[0] + one * t.normal[1] + two * t.normal[2]).normalized();
        f.depth = (centre - f.point).dot(f.normal);
        const Vec3 aside = centre - f.point - f.depth * f.normal;
        one += t.dual_one.dot(aside);
        two += t.dual_two.dot(aside);
    }
    return f;
}

bool WallSurface::meet(int triangle, const Vec3& centre, SurfaceHit& hit) const
{
    const Triangle& t = triangles_[std::size_t(triangle)];
    const Foot f = foot(t, centre);
    hit = {f.normal, f.depth, triangle};
    const auto lowest = std::min_element(f.weight.begin(), f.weight.end());
    if (*lowest >= -overlap_share) return true;
    if (t.sharp[0] && f.weight[0] < 0.0) return meet_edge(t, 0, centre, hit);
    return (t.vertex[1] >= 0 && meet_corner(t, 1, centre, hit)) || (t.vertex[2] >= 0 && meet_corner(t, 2, centre, hit));
}

/// An edge is touched only where the centre lies beyond both faces that share it; elsewhere it is the shadow of a face.
bool WallSurface::meet_edge(const Triangle& t, int edge, const Vec3& centre, SurfaceHit& hit) const
{
    const auto i = std::size_t((edge + 1) % 3), j = std::size_t((edge + 2) % 3);
    const Vec3 along = t.corner[j] - t.corner[i];
    const double share = (centre - t.corner[i]).dot(along) / along.squaredNorm();
    if (share < 0.0) return t.vertex[i] >= 0 && meet_corner(t, int(i), centre, hit);
    if (share > 1.0) return t.vertex[j] >= 0 && meet_corner(t, int(j), centre, hit);
    const Vec3 from = centre - (t.corner[i] + share * along);
    hit.depth = from.norm();
    if (hit.depth == 0.0 || from.dot(t.across[std::size_t(edge)]) > 1e-9 * hit.depth) return false;
    hit.normal = from / hit.depth;
    return true;
}

/// A corner is touched only where the centre lies behind all edges that leave it.
bool WallSurface::meet_corner(const Triangle& t, int corner, const Vec3& centre, SurfaceHit& hit) const
{
    const Vec3 from = centre - t.corner[std::size_t(corner)];
    hit.depth = from.norm();
    if (hit.depth == 0.0) return false;
    for (const Vec3& spoke : spokes_[std::size_t(t.vertex[std::size_t(corner)])])
        if (from.dot(spoke) > 1e-9 * hit.depth) return false;
    hit.normal = from / hit.depth;
    return true;
}

Vec3 WallSurface::normal_before(const SurfaceHit& hit, const Vec3& centre, const Vec3& way) const
{
    const Triangle& t = triangles_[std::size_t(hit.triangle)];
    if (t.flat) return hit.normal;
    const Vec3 then = foot(t, centre - way).normal, now = foot(t, centre).normal;
    return (hit.normal + then - now).normalized();
}

std::array<int, 3> WallSurface::bin(const Vec3& x) const
{
    std::array<int, 3> b;
    for (std::size_t a = 0; a < 3; ++a)
        b[a] = int(std::clamp((x[int(a)] - low_[int(a)]) / bin_width_, 0.0, double(bins_[a] - 1)));
    return b;
}

void WallSurface::fill_bins()
{
    if (triangles_.empty()) return;
    low_ = high_ = triangles_.front().corner[0];
    double size = 0.0;
    for (const auto& t : triangles_)
        for (std::size_t k = 0; k < 3; ++k) {
            low_ = low_.cwiseMin(t.corner[k]);
            high_ = high_.cwiseMax(t.corner[k]);
            size += (t.corner[(k + 1) % 3] - t.corner[k]).norm() / double(3 * triangles_.size());
        }
    const Vec3 extent = high_ - low_;
    bin_width_ = std::max(2.0 * size, std::cbrt(extent[0] * extent[1] * extent[2] / double(8 * triangles_.size() + 64)));
    for (std::size_t a = 0; a < 3; ++a) bins_[a] = std::max(1, int(extent[int(a)] / bin_width_) + 1);
    std::vector<std::vector<int>> lists(std::size_t(bins_[0]) * std::size_t(bins_[1]) * std::size_t(bins_[2]));
    for (int n = 0; n < int(triangles_.size()); ++n) {
        const auto& t = triangles_[std::size_t(n)];
        const auto from = bin(t.corner[0].cwiseMin(t.corner[1]).cwiseMin(t.corner[2]));
        const auto to = bin(t.corner[0].cwiseMax(t.corner[1]).cwiseMax(t.corner[2]));
        for (int i = from[0]; i <= to[0]; ++i)
            for (int j = from[1]; j <= to[1]; ++j)
                for (int k = from[2]; k <= to[2]; ++k)
                    lists[(std::size_t(i) * std::size_t(bins_[1]) + std::size_t(j)) * std::size_t(bins_[2]) + std::size_t(k)].push_back(n);
    }
    bin_start_.assign(1, 0);
    for (const auto& list : lists) {
        bin_triangle_.insert(bin_triangle_.end(), list.begin(), list.end());
        bin_start_.push_back(int(bin_triangle_.size()));
    }
}

void WallSurface::candidates(const Vec3& centre, double reach, std::vector<int>& found) const
{
    found.clear();
    if (empty()) return;
    const Vec3 around = Vec3::Constant(reach);
    if (((centre + around).array() < low_.array()).any() || ((centre - around).array() > high_.array()).any()) return;
    const auto from = bin(centre - around), to = bin(centre + around);
    for (int i = from[0]; i <= to[0]; ++i)
        for (int j = from[1]; j <= to[1]; ++j)
            for (int k = from[2]; k <= to[2]; ++k) {
                const auto b = (std::size_t(i) * std::size_t(bins_[1]) + std::size_t(j)) * std::size_t(bins_[2]) + std::size_t(k);
                found.insert(found.end(), bin_triangle_.begin() + bin_start_[b], bin_triangle_.begin() + bin_start_[b + 1]);
            }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::erase_if(found, [&](int n) { return !near(n, centre, reach); });
}

bool WallSurface::near(int triangle, const Vec3& centre, double reach) const
{
    const auto& t = triangles_[std::size_t(triangle)];
    const Vec3 from = centre - t.corner[0];
    const double bulge = 0.25 * (t.bend[0].norm() + t.bend[1].norm() + t.bend[2].norm()); // of the patch above its flat triangle
    const double one = t.dual_one.dot(from), two = t.dual_two.dot(from), wanted = reach + bulge;
    if (one >= 0.0 && two >= 0.0 && one + two <= 1.0)
        return std::abs(from.dot(t.dual_one.cross(t.dual_two).normalized())) < wanted;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 along = t.corner[(k + 1) % 3] - t.corner[k], to = centre - t.corner[k];
        const double share = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
        if ((to - share * along).squaredNorm() < wanted * wanted) return true;
    }
    return false;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/wall_surface.hpp"
#include "core/base/error.hpp"
#include "physics/particles/triangle_mesh.hpp"
#include "physics/particles/wall_faces.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using core::Vec3;

/// Middle bend of the curve between two points with normals m and n: it leaves both at right angles to the normal.
Vec3 bend_of(const Vec3& a, const Vec3& m, const Vec3& b, const Vec3& n)
{
    const Vec3 chord = b - a;
    return (m + n) * ((chord.dot(n) - chord.dot(m)) / (2.0 * (1.0 + m.dot(n))));
}

/// Coordinates of a foot: each is 0 on the edge opposite to its corner and 1 in the corner.
std::array<double, 3> weights_of(const PatchPlace<double>& foot) { return {1.0 - foot.one - foot.two, foot.one, foot.two}; }

} // namespace

WallSurface::WallSurface(std::span<const Vec3> vertices, std::span<const std::array<int, 4>> quads, double smooth_angle,
                         std::span<const int> materials)
{
    const WallFaces faces(vertices, quads, smooth_angle, Rims::go_on);
    spokes_ = faces.spokes();
    const bool many = materials.size() > 1;
    if (!materials.empty()) material_ = {materials.front()};
    for (std::size_t f = 0; f < quads.size(); ++f) {
        add_triangles(faces, int(f));
        if (many) material_.resize(triangles_.size(), materials[f]);
    }
    fill_bins();
}

WallSurface::WallSurface(const TriangleMesh& mesh, double smooth_angle, int material) : two_sided_(true), material_{material}
{
    std::vector<std::array<int, 4>> quads;
    for (const auto& [a, b, c] : mesh.triangles) quads.push_back({a, b, c, c});
    const WallFaces faces(mesh.vertices, quads, smooth_angle, Rims::end);
    spokes_ = faces.spokes();
    for (int f = 0; f < int(quads.size()); ++f) add_whole(faces, f);
    fill_bins();
}

/// A face with three corners.
void WallSurface::add_whole(const WallFaces& faces, int face)
{
    constexpr std::array<int, 3> opposite{1, 3, 0}; // numbers of the edges; the third has no length
    Triangle t;
    for (std::size_t c = 0; c < 3; ++c) {
        t.corner[c] = faces.corner(face, int(c));
        t.vertex[c] = faces.sharp_vertex(face, int(c));
        t.sharp[c] = faces.sharp(face, opposite[c]);
        t.across[c] = faces.across(face, opposite[c]);
    }
    add_patch(t, {faces.corner_normal(face, 0), faces.corner_normal(face, 1), faces.corner_normal(face, 2)});
    triangles_.push_back(t);
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
        t.sharp[0] = faces.sharp(face, k);
        t.across[0] = faces.across(face, k);
        t.vertex = {-1, faces.sharp_vertex(face, k), faces.sharp_vertex(face, (k + 1) % 4)};
        add_patch(t, {mean, normal[a], normal[b]});
        triangles_.push_back(t);
    }
}

void WallSurface::add_patch(Triangle& t, const std::array<Vec3, 3>& normal)
{
    const Vec3 one = t.corner[1] - t.corner[0], two = t.corner[2] - t.corner[0], up = one.cross(two);
    const std::array<Vec3, 3> dual{two.cross(up) / up.squaredNorm(), up.cross(one) / up.squaredNorm(), up.normalized()};
    std::array<Vec3, 3> bend, local_normal;
    t.bulge = t.low = t.high = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto i = (c + 1) % 3, j = (c + 2) % 3;
        const Vec3 b = bend_of(t.corner[i], normal[i], t.corner[j], normal[j]);
        bend[c] = Vec3(dual[0].dot(b), dual[1].dot(b), dual[2].dot(b));
        local_normal[c] = Vec3(dual[0].dot(normal[c]), dual[1].dot(normal[c]), dual[2].dot(normal[c]));
        t.bulge += 0.25 * b.norm(); // two of the triangle's coordinates multiply to 1/4 at most
        t.low += 0.25 * std::min(0.0, bend[c][2]);
        t.high += 0.25 * std::max(0.0, bend[c][2]);
    }
    WallPatch patch;
    auto next = patch.value.begin();
    const auto put = [&](const Vec3& v) { next = std::copy(v.data(), v.data() + 3, next); };
    put(t.corner[0]);
    for (const Vec3& v : dual) put(v);
    put(one);
    put(two);
    for (const Vec3& v : {bend[2], bend[1], Vec3(bend[0] - bend[1] - bend[2])}) put(v);
    for (const Vec3& v : {local_normal[0], Vec3(local_normal[1] - local_normal[0]), Vec3(local_normal[2] - local_normal[0])}) put(v);
    patches_.push_back(patch);

    const double least = std::min({local_normal[0][2], local_normal[1][2], local_normal[2][2]}); // of the normal's length, inside
    const Vec3 to_zero(-1, -1, 0);
    const std::array<Vec3, 3> coordinate{Vec3::UnitX(), Vec3::UnitY(), to_zero};
    for (std::size_t c = 0; c < 3; ++c) {
        double room = 0.0, lean = 0.0;
        for (std::size_t n = 0; n < 3; ++n) {
            room += 0.25 * std::abs(coordinate[c].dot(bend[n]));
            lean = std::max(lean, std::abs(coordinate[c].dot(local_normal[n])) / least);
        }
        t.room[c] = 2e-3 + 1.01 * room; // twice the overlap of neighbours
        t.lean[c] = 1.01 * lean;
    }
    t.slope = {dual[0].norm(), dual[1].norm(), (dual[0] + dual[1]).norm()};
    t.plain = std::max({t.vertex[0], t.vertex[1], t.vertex[2]}) < 0 && least > 0.5; // a sharp edge has sharp corners
}

bool WallSurface::beyond_sharp_edge(int triangle, const PatchPlace<double>& foot) const
{
    const Triangle& t = triangles_[std::size_t(triangle)];
    const auto weight = weights_of(foot);
    return (t.sharp[0] && weight[0] < 0.0) || (t.sharp[1] && weight[1] < 0.0) || (t.sharp[2] && weight[2] < 0.0);
}

bool WallSurface::meet_rim(int triangle, const PatchPlace<double>& foot, const Vec3& centre, SurfaceHit& hit) const
{
    const Triangle& t = triangles_[std::size_t(triangle)];
    const auto weight = weights_of(foot);
    for (std::size_t c = 0; c < 3; ++c)
        if (t.sharp[c] && weight[c] < 0.0 && meet_edge(t, c, centre, hit)) return true;
    for (std::size_t c = 0; c < 3; ++c)
        if (t.vertex[c] >= 0 && meet_corner(t, c, centre, hit)) return true;
    return false;
}

/// An edge is touched only where the centre lies beyond both faces that share it; elsewhere it is the shadow of a face.
bool WallSurface::meet_edge(const Triangle& t, std::size_t edge, const Vec3& centre, SurfaceHit& hit) const
{
    const Vec3 begin = t.corner[(edge + 1) % 3], along = t.corner[(edge + 2) % 3] - begin;
    const double share = (centre - begin).dot(along) / along.squaredNorm();
    if (share < 0.0 || share > 1.0) return false; // perhaps a corner
    const Vec3 from = centre - (begin + share * along);
    hit.depth = from.norm();
    if (hit.depth == 0.0 || from.dot(t.across[edge]) > 1e-9 * hit.depth) return false;
    hit.normal = from / hit.depth;
    return true;
}

/// A corner is touched only where the centre lies behind all edges that leave it.
bool WallSurface::meet_corner(const Triangle& t, std::size_t corner, const Vec3& centre, SurfaceHit& hit) const
{
    const Vec3 from = centre - t.corner[corner];
    hit.depth = from.norm();
    if (hit.depth == 0.0) return false;
    for (const Vec3& spoke : spokes_[std::size_t(t.vertex[corner])])
        if (from.dot(spoke) > 1e-9 * hit.depth) return false;
    hit.normal = from / hit.depth;
    return true;
}

std::array<int, 3> WallSurface::bin(const Vec3& x) const
{
    std::array<int, 3> b;
    for (std::size_t a = 0; a < 3; ++a) b[a] = int(std::clamp((x[int(a)] - low_[int(a)]) / bin_width_, 0.0, double(bins_[a] - 1)));
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
    const std::size_t bins = std::size_t(bins_[0]) * std::size_t(bins_[1]) * std::size_t(bins_[2]);
    std::vector<std::vector<int>> lists(bins);
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

void WallSurface::candidates(const Vec3& centre, double radius, double skin, std::vector<int>& found) const
{
    found.clear();
    if (empty()) return;
    const Vec3 around = Vec3::Constant(radius + skin);
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
    std::erase_if(found, [&](int n) { return !near(n, centre, radius, skin); });
}

CentreBounds WallSurface::bounds(int triangle, double radius, double skin) const
{
    const auto& t = triangles_[std::size_t(triangle)];
    const auto& patch = patches_[std::size_t(triangle)];
    const double reach = radius + skin, everywhere = -1e300;
    CentreBounds b;
    constexpr std::array<int, 3> rows{WallPatch::dual + 6, WallPatch::dual, WallPatch::dual + 3};
    for (std::size_t n = 0; n < 3; ++n) {
        const int row = rows[n];
        for (int a = 0; a < 3; ++a) b.value[4 * n + std::size_t(a)] = patch[row + a];
        b.value[4 * n + 3] = patch[row] * patch[0] + patch[row + 1] * patch[1] + patch[row + 2] * patch[2];
    }
    b.value[12] = t.low - reach;
    b.value[13] = t.high + reach;
    for (std::size_t c = 0; c < 3; ++c) b.value[14 + c] = t.plain ? -(t.room[c] + t.lean[c] * reach + t.slope[c] * skin) : everywhere;
    return b;
}

bool WallSurface::near(int triangle, const Vec3& centre, double radius, double skin) const
{
    const auto& t = triangles_[std::size_t(triangle)];
    const double reach = radius + skin, wanted = reach + t.bulge;
    const PatchPoint<double> at = patch_point(patches_[std::size_t(triangle)], centre[0], centre[1], centre[2]);
    if (at.height >= t.high + reach || at.height <= t.low - reach) return false;
    const std::array<double, 3> weight{at.one, at.two, 1.0 - at.one - at.two};
    if (t.plain) {
        bool inside = true;
        for (std::size_t c = 0; c < 3; ++c) inside = inside && weight[c] > -(t.room[c] + t.lean[c] * reach + t.slope[c] * skin);
        return inside;
    }
    if (std::min({weight[0], weight[1], weight[2]}) >= 0.0) return true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 along = t.corner[(k + 1) % 3] - t.corner[k], to = centre - t.corner[k];
        const double share = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
        if ((to - share * along).squaredNorm() < wanted * wanted) return true;
    }
    return false;
}

} // namespace physics

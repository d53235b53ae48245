// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/wall_faces.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using core::Vec3;

std::pair<int, int> edge_key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// An edge that one face alone has.
struct Rim {
    int face, edge;
    Vec3 from, to, normal, inward; ///< normal and way into the face of length 1
};

/// Does the wall go on from one rim in another, straight or round? Chords of the same arc lie apart at their middles.
bool goes_on(const Rim& rim, const Rim& other, double least_cosine)
{
    constexpr double gap = 0.1, beyond = 0.01; // of the lengths of the edges
    const Vec3 middle = 0.5 * (rim.from + rim.to), along = other.to - other.from;
    const double longer = std::max((rim.to - rim.from).norm(), along.norm());
    if ((middle - 0.5 * (other.from + other.to)).squaredNorm() > longer * longer) return false;
    if (rim.face == other.face || rim.normal.dot(other.normal) < least_cosine || rim.inward.dot(other.inward) > 0) return false;
    const double share = (middle - other.from).dot(along) / along.squaredNorm();
    return share > -beyond && share < 1 + beyond && (middle - (other.from + share * along)).norm() < gap * longer;
}

} // namespace

WallFaces::WallFaces(std::span<const Vec3> vertices, std::span<const std::array<int, 4>> quads, double smooth_angle, Rims rims)
    : vertices_(vertices), quads_(quads)
{
    for (int f = 0; f < int(quads.size()); ++f) {
        for (const int v : quads[std::size_t(f)])
            core::require<core::ConfigError>(v >= 0 && v < int(vertices.size()), core::text("wall face ", f, " has no corner ", v));
        normal_.push_back((corner(f, 2) - corner(f, 0)).cross(corner(f, 3) - corner(f, 1)));
        core::require<core::ConfigError>(normal_.back().norm() > 0.0, core::text("wall face ", f, " has no area"));
        for (int k = 0; k < 4; ++k) {
            const int a = vertex(f, k), b = vertex(f, (k + 1) % 4);
            if (a != b) edges_[edge_key(a, b)].push_back(f);
        }
    }
    find_sharp_edges(smooth_angle);
    if (rims == Rims::go_on) join_rims(smooth_angle);
    find_sharp_corners();
}

int WallFaces::neighbour(int face, int k) const
{
    const auto found = edges_.find(edge_key(vertex(face, k), vertex(face, (k + 1) % 4)));
    if (found == edges_.end()) return -1;
    for (const int other : found->second)
        if (other != face) return other;
    return -1;
}

void WallFaces::find_sharp_edges(double smooth_angle)
{
    const double least = std::cos(smooth_angle);
    for (int f = 0; f < int(quads_.size()); ++f) {
        auto& sharp = sharp_.emplace_back();
        for (int k = 0; k < 4; ++k) {
            const int other = neighbour(f, k);
            const bool has_length = vertex(f, k) != vertex(f, (k + 1) % 4);
            sharp[std::size_t(k)] =
                has_length && (other < 0 || normal_[std::size_t(f)].normalized().dot(normal_[std::size_t(other)].normalized()) < least);
        }
    }
}

void WallFaces::join_rims(double smooth_angle)
{
    std::vector<Rim> rims;
    for (int f = 0; f < int(quads_.size()); ++f)
        for (int k = 0; k < 4; ++k) {
            if (!sharp(f, k) || neighbour(f, k) >= 0) continue;
            const Vec3 from = corner(f, k), to = corner(f, (k + 1) % 4), normal = normal_[std::size_t(f)].normalized();
            rims.push_back({f, k, from, to, normal, normal.cross(to - from).normalized()});
        }
    for (const Rim& rim : rims)
        for (const Rim& other : rims)
            if (goes_on(rim, other, std::cos(smooth_angle))) {
                sharp_[std::size_t(rim.face)][std::size_t(rim.edge)] = false;
                break;
            }
}

void WallFaces::find_sharp_corners()
{
    sharp_vertex_.assign(vertices_.size(), -1);
    for (int f = 0; f < int(quads_.size()); ++f)
        for (int k = 0; k < 4; ++k)
            if (sharp(f, k))
                for (const int v : {vertex(f, k), vertex(f, (k + 1) % 4)})
                    if (sharp_vertex_[std::size_t(v)] < 0) {
                        sharp_vertex_[std::size_t(v)] = int(spokes_.size());
                        spokes_.emplace_back();
                    }
    for (const auto& [edge, faces] : edges_)
        for (const auto& [from, to] : {edge, std::pair{edge.second, edge.first}})
            if (sharp_vertex_[std::size_t(from)] >= 0)
                spokes_[std::size_t(sharp_vertex_[std::size_t(from)])].push_back(
                    (vertices_[std::size_t(to)] - vertices_[std::size_t(from)]).normalized());
}

/// What a face counts for in the normal of a vertex.
double WallFaces::share_at(int face, int centre) const
{
    if (!has_three_corners(face)) return 1.0;
    int k = 0;
    while (vertex(face, k) != centre) ++k;
    const Vec3 one = corner(face, (k + 1) % 3) - corner(face, k), two = corner(face, (k + 2) % 3) - corner(face, k);
    return std::atan2(one.cross(two).norm(), one.dot(two));
}

/// Mean over the faces that are reached around the vertex without crossing a sharp edge.
Vec3 WallFaces::corner_normal(int face, int k) const
{
    const int centre = vertex(face, k);
    std::vector<int> group{face};
    for (std::size_t n = 0; n < group.size(); ++n)
        for (int e = 0; e < 4; ++e) {
            const int f = group[n];
            if (sharp(f, e) || (vertex(f, e) != centre && vertex(f, (e + 1) % 4) != centre)) continue;
            const int other = neighbour(f, e);
            if (other < 0) continue; // the edge of no length of a face with three corners
            if (std::find(group.begin(), group.end(), other) == group.end()) group.push_back(other);
        }
    std::sort(group.begin(), group.end()); // the same sum for all faces of the group
    Vec3 sum = Vec3::Zero();
    for (const int f : group) sum += share_at(f, centre) * normal_[std::size_t(f)].normalized();
    return sum.normalized();
}

Vec3 WallFaces::across(int face, int k) const
{
    const int other = neighbour(face, k);
    if (other < 0) return Vec3::Zero();
    const Vec3 a = corner(face, k), along = (corner(face, (k + 1) % 4) - a).normalized();
    Vec3 middle = Vec3::Zero();
    for (int c = 0; c < 4; ++c) middle += 0.25 * corner(other, c);
    const Vec3 in = middle - a;
    return (in - in.dot(along) * along).normalized();
}

} // namespace physics

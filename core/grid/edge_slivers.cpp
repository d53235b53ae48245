// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// How the edges of a side bend to the points where they cross those of its masters.
#include "core/grid/side_overlap.hpp"
#include <algorithm>
#include <map>

namespace core {
namespace {

struct Crossing {
    double share;
    Vec3 point;
    const SideOverlap* overlap;
};

/// The crossings of one master after those of another, each place once.
std::vector<Crossing> in_order(const std::vector<Crossing>& crossings, double edge)
{
    constexpr double same = 1e-9; // of the edge
    std::vector<Crossing> kept;
    for (const Crossing& c : crossings)
        if (std::none_of(kept.begin(), kept.end(), [&](const Crossing& k) { return (k.point - c.point).norm() < same * edge; }))
            kept.push_back(c);
    const auto mean_share = [&](const SideOverlap* overlap) {
        double sum = 0, count = 0;
        for (const Crossing& c : kept)
            if (c.overlap == overlap) {
                sum += c.share;
                ++count;
            }
        return sum / count;
    };
    std::stable_sort(kept.begin(), kept.end(), [&](const Crossing& a, const Crossing& b) {
        return a.overlap == b.overlap ? a.share < b.share : mean_share(a.overlap) < mean_share(b.overlap);
    });
    return kept;
}

/// The points of an edge. From one master to the next it follows their common rim, by the vertices between.
std::vector<Vec3> path_through(const std::vector<Crossing>& crossings)
{
    std::vector<Vec3> path;
    for (std::size_t n = 0; n < crossings.size(); ++n) {
        if (n > 0 && crossings[n].overlap != crossings[n - 1].overlap) {
            const Vec3 &from = crossings[n - 1].point, &to = crossings[n].point;
            const double distance = (to - from).norm();
            const auto first = std::ptrdiff_t(path.size());
            for (const Vec3& v : crossings[n].overlap->rim)
                if ((v - from).norm() < distance && (v - to).norm() < distance) path.push_back(v);
            std::sort(path.begin() + first, path.end(),
                      [&](const Vec3& a, const Vec3& b) { return (a - from).norm() < (b - from).norm(); });
        }
        path.push_back(crossings[n].point);
    }
    return path;
}

/// Area vector between a straight edge and a path from its start to its end [m2].
Vec3 swept(const Vec3& start, const std::vector<Vec3>& path, const Vec3& end)
{
    Vec3 before = Vec3::Zero(), sum = Vec3::Zero(); // places relative to the start
    for (const Vec3& x : path) {
        sum += 0.5 * before.cross(x - start);
        before = x - start;
    }
    return sum + 0.5 * before.cross(end - start);
}

} // namespace

EdgeSlivers edge_slivers(const SideTiling& tiling, const std::vector<const SideOverlap*>& overlaps)
{
    EdgeSlivers slivers{Array3<Vec3>({tiling.np(), tiling.nq() + 1, 1}, 0, Vec3::Zero()),
                        Array3<Vec3>({tiling.np() + 1, tiling.nq(), 1}, 0, Vec3::Zero())};
    std::map<std::array<int, 3>, std::vector<Crossing>> edges;
    for (const SideOverlap* overlap : overlaps)
        for (const EdgePoint& e : overlap->points) edges[{e.axis, e.vertex.p, e.vertex.q}].push_back({e.share, e.point, overlap});
    for (const auto& [edge, crossings] : edges) {
        const auto [axis, p, q] = edge;
        const Vec3 start = tiling.vertex(p, q), end = tiling.vertex(p + (axis == 0), q + (axis == 1));
        slivers[std::size_t(axis)](p, q, 0) = swept(start, path_through(in_order(crossings, (end - start).norm())), end);
    }
    for (const SideOverlap* overlap : overlaps)
        for (const CededArea& c : overlap->ceded) slivers[std::size_t(c.axis)](c.vertex.p, c.vertex.q, 0) += c.area;
    return slivers;
}

Vec3 bent_area(const SideTiling& tiling, const EdgeSlivers& slivers, int p, int q)
{
    return tiling.area(p, q) + slivers[0](p, q, 0) + slivers[1](p + 1, q, 0) - slivers[0](p, q + 1, 0) - slivers[1](p, q, 0);
}

} // namespace core

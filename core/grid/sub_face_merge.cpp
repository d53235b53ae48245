// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/sub_face_merge.hpp"
#include <algorithm>
#include <map>

namespace core {
namespace {

/// A neighbour of a face of the other side, and what the edge between sweeps when an area goes there.
struct Way {
    FaceIndex to;
    CededArea edge;
};

/// @param area  In the direction of the other side's area vectors.
std::array<Way, 4> ways_from(FaceIndex b, const Vec3& area)
{
    return {{{{b.p + 1, b.q}, {1, {b.p + 1, b.q}, -area}},
             {{b.p - 1, b.q}, {1, b, area}},
             {{b.p, b.q + 1}, {0, {b.p, b.q + 1}, area}},
             {{b.p, b.q - 1}, {0, b, -area}}}};
}

} // namespace

void merge_slivers(const SideTiling& master, const SideTiling& other, double smallest, SideOverlap& result)
{
    const double sense = result.same_sense ? 1 : -1;
    std::map<std::array<int, 4>, std::size_t> number;
    const auto key = [](FaceIndex a, FaceIndex b) { return std::array{a.p, a.q, b.p, b.q}; };
    for (std::size_t n = 0; n < result.faces.size(); ++n) number[key(result.faces[n].master, result.faces[n].other)] = n;
    std::vector<bool> gone(result.faces.size(), false);
    for (std::size_t n = 0; n < result.faces.size(); ++n) {
        const auto [a, b, area, centre] = result.faces[n];
        if (area.norm() >= smallest * std::min(master.area(a.p, a.q).norm(), other.area(b.p, b.q).norm())) continue;
        const auto ways = ways_from(b, sense * area);
        const Way* best = nullptr;
        double largest = area.norm();
        for (const Way& way : ways)
            if (const auto found = number.find(key(a, way.to)); found != number.end() && !gone[found->second])
                if (const double size = result.faces[found->second].area.norm(); size > largest) {
                    largest = size;
                    best = &way;
                }
        if (best == nullptr) continue;
        result.faces[number[key(a, best->to)]].area += area;
        result.ceded.push_back(best->edge);
        gone[n] = true;
    }
    std::size_t kept = 0;
    for (std::size_t n = 0; n < gone.size(); ++n)
        if (!gone[n]) result.faces[kept++] = result.faces[n];
    result.faces.resize(kept);
}

} // namespace core

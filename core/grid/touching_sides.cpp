// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/touching_sides.hpp"
#include "core/grid/side_overlap.hpp"
#include <algorithm>

namespace core {
namespace {

struct Box {
    Vec3 low, high;
};

Box box_of(const SideTiling& tiling)
{
    Box box{tiling.vertex(0, 0), tiling.vertex(0, 0)};
    for (int q = 0; q <= tiling.nq(); ++q)
        for (int p = 0; p <= tiling.np(); ++p) {
            box.low = box.low.cwiseMin(tiling.vertex(p, q));
            box.high = box.high.cwiseMax(tiling.vertex(p, q));
        }
    return box;
}

bool boxes_touch(const Box& a, const Box& b)
{
    const double slack = 0.01 * std::min((a.high - a.low).norm(), (b.high - b.low).norm());
    return ((a.low - b.high).array() < slack).all() && ((b.low - a.high).array() < slack).all();
}

double area_of(const SideTiling& tiling)
{
    double sum = 0;
    for (int q = 0; q < tiling.nq(); ++q)
        for (int p = 0; p < tiling.np(); ++p) sum += tiling.area(p, q).norm();
    return sum;
}

/// Area on which two sides lie on each other with their cells on opposite sides.
double shared_area(const Vertices& block_a, const SideTiling& a, const Vertices& block_b, const SideTiling& b, const Vec3& shift)
{
    double sum = 0;
    for (const SubFace& f : overlap(a, b).faces) {
        const Vec3 to_a = cell_shape(block_a, a.cell(f.master.p, f.master.q)).centroid - f.centre;
        const Vec3 to_b = cell_shape(block_b, b.cell(f.other.p, f.other.q)).centroid + shift - f.centre;
        if (to_a.dot(f.area) * to_b.dot(f.area) < 0) sum += f.area.norm();
    }
    return sum;
}

} // namespace

std::vector<TouchingSides> touching_sides(const MultiBlock& grid, const Topology& topology)
{
    constexpr double smallest_share = 1e-3; // less may be the curvature of two sides that meet at a rim
    std::vector<Vec3> shifts{Vec3::Zero()};
    for (const Vec3& period : grid.periods) {
        shifts.push_back(period);
        shifts.push_back(-period);
    }
    std::vector<TouchingSides> found;
    const auto& sides = topology.boundaries;
    for (std::size_t m = 0; m < sides.size(); ++m) {
        const Vertices& block_a = grid.blocks[std::size_t(sides[m].block)];
        const SideTiling a(block_a, sides[m].side);
        for (std::size_t n = m + 1; n < sides.size(); ++n)
            for (const Vec3& shift : shifts) {
                const Vertices& block_b = grid.blocks[std::size_t(sides[n].block)];
                const SideTiling b(block_b, sides[n].side, shift);
                if (!boxes_touch(box_of(a), box_of(b))) continue;
                const double share = shared_area(block_a, a, block_b, b, shift) / std::min(area_of(a), area_of(b));
                if (share > smallest_share)
                    found.push_back({{sides[m].block, sides[n].block, sides[m].side, sides[n].side, -shift}, share});
            }
    }
    return found;
}

} // namespace core

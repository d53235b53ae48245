// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/touching_sides.hpp"
#include "core/base/error.hpp"
#include "core/grid/side_overlap.hpp"
#include <algorithm>
#include <numbers>

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

constexpr double smallest_share = 1e-3; // less may be the curvature of two sides that meet at a rim

std::string words(const PeriodicTurn& turn)
{
    return text("a turn of ", turn.angle * 180 / std::numbers::pi, " degrees about (", turn.axis.transpose(), ") through (",
                turn.point.transpose(), ") m");
}

Vertices turned(const Vertices& block, const Motion& motion)
{
    Vertices result = block;
    for (Vec3& x : result.data()) x = motion.of_position(x);
    return result;
}

} // namespace

std::vector<TouchingSides> touching_sides(const MultiBlock& grid, const Topology& topology)
{
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

void require_turn_joins(const MultiBlock& grid, const Topology& topology)
{
    if (!grid.turn) return;
    const auto name = [](const Boundary& side) { return text("side ", side_words[std::size_t(side.side)], " of block ", side.block); };
    for (const Boundary& a : topology.boundaries) {
        const Vertices block_a = turned(grid.blocks[std::size_t(a.block)], grid.turn->motion());
        const SideTiling tiling_a(block_a, a.side);
        for (const Boundary& b : topology.boundaries) {
            const Vertices& block_b = grid.blocks[std::size_t(b.block)];
            const SideTiling tiling_b(block_b, b.side);
            if (!boxes_touch(box_of(tiling_a), box_of(tiling_b))) continue;
            const double share =
                shared_area(block_a, tiling_a, block_b, tiling_b, Vec3::Zero()) / std::min(area_of(tiling_a), area_of(tiling_b));
            const bool itself = a.block == b.block && a.side == b.side;
            require<ConfigError>(share <= smallest_share,
                                 text(words(*grid.turn), " lays ", name(a), " on ",
                                      itself ? std::string("itself: cut the block at the axis")
                                             : name(b) + ", but their points do not match: give both the same points"));
        }
    }
    require<ConfigError>(topology.turns(), text(words(*grid.turn), " lays no side of the grid on another: give the angle and the axis of "
                                                                   "the sector that the grid fills"));
}

} // namespace core

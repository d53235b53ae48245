// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/area_changes.hpp"
#include <algorithm>

namespace core {
namespace {

bool is_bent(const std::vector<BentSide>& sides, BlockId block, Side side)
{
    return std::any_of(sides.begin(), sides.end(), [&](const BentSide& s) { return s.block == block && s.side == side; });
}

/// Adds the changes along the edges of one side.
class Bending {
public:
    Bending(const MultiBlock& grid, const Topology& topology, const std::vector<BentSide>& sides, std::vector<AreaChange>& changes)
        : grid_(grid), topology_(topology), sides_(sides), changes_(changes)
    {
    }

    void add(const BentSide& bent)
    {
        const SideTiling tiling(grid_.blocks[std::size_t(bent.block)], bent.side);
        const EdgeSlivers slivers = edge_slivers(tiling, bent.overlaps);
        const auto t = tangential_axes(bent.side);
        // Area vectors of a tiling point along its first axis cross its second: for axis 1 against increasing index.
        const double outward = (axis_of(bent.side) == 1) == is_high(bent.side) ? -1 : 1;
        for (int along = 0; along < 2; ++along)
            for (int q = 0; q < tiling.nq() + (along == 0); ++q)
                for (int p = 0; p < tiling.np() + (along == 1); ++p) {
                    // The edge along one axis bounds the face across the other.
                    const Vec3 area = (along == 0 ? outward : -outward) * slivers[std::size_t(along)](p, q, 0);
                    if (area == Vec3::Zero()) continue;
                    Index3 cell;
                    cell[axis_of(bent.side)] = is_high(bent.side) ? topology_.cells[std::size_t(bent.block)][axis_of(bent.side)] - 1 : 0;
                    cell[t[0]] = p;
                    cell[t[1]] = q;
                    add_face(bent, t[std::size_t(1 - along)], cell, area);
                }
    }

private:
    void add_face(const BentSide& bent, int axis, Index3 face, const Vec3& area)
    {
        changes_.push_back({bent.block, axis, face, area});
        const int n = topology_.cells[std::size_t(bent.block)][axis];
        if (face[axis] != 0 && face[axis] != n) return;
        if (const auto& beyond = topology_.neighbour(bent.block, side_of(axis, face[axis] != 0)))
            add_beyond(bent, *beyond, axis, face, area);
    }

    /// The same face seen from the block beyond, unless that finds it bent by itself.
    void add_beyond(const BentSide& bent, const Neighbour& beyond, int axis, Index3 face, const Vec3& area)
    {
        const auto along = [&](int m) { return std::size_t(m); };
        if (face[axis] == 0) face[axis] = -1; // the cell beyond
        const Index3 cell = beyond.map(face);
        const int normal = axis_of(bent.side), there = beyond.map.axis[along(normal)];
        const Side side = side_of(there, is_high(bent.side) == (beyond.map.sign[along(normal)] > 0));
        const int last = topology_.cells[std::size_t(beyond.block)][there] - 1;
        if (cell[there] == (is_high(side) ? last : 0) && is_bent(sides_, beyond.block, side)) return;
        const Vec3 change = double(beyond.map.sign[along(axis)]) * beyond.motion.of_vector(area);
        Index3 at = cell;
        if (is_high(beyond.side)) ++at[axis_of(beyond.side)];
        changes_.push_back({beyond.block, axis_of(beyond.side), at, change});
        if (!topology_.at_boundary(beyond.block, side)) return;
        // The boundary face of that cell has the same edge.
        const double sign = is_high(side) == is_high(beyond.side) ? -1 : 1;
        Index3 boundary = cell;
        if (is_high(side)) ++boundary[there];
        changes_.push_back({beyond.block, there, boundary, sign * change});
    }

    const MultiBlock& grid_;
    const Topology& topology_;
    const std::vector<BentSide>& sides_;
    std::vector<AreaChange>& changes_;
};

} // namespace

std::vector<AreaChange> area_changes(const MultiBlock& grid, const Topology& topology, const std::vector<BentSide>& sides)
{
    std::vector<AreaChange> changes;
    Bending bending(grid, topology, sides, changes);
    for (const BentSide& side : sides) bending.add(side);
    return changes;
}

} // namespace core

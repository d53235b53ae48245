// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/area_changes.hpp"
#include "core/base/error.hpp"
#include "core/grid/hexahedron.hpp"
#include <algorithm>
#include <map>
#include <tuple>

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

using FaceKey = std::tuple<BlockId, int, int, int, int>;

FaceKey key_of(BlockId block, int axis, Index3 face) { return {block, axis, face.i, face.j, face.k}; }

} // namespace

std::vector<AreaChange> area_changes(const MultiBlock& grid, const Topology& topology, const std::vector<BentSide>& sides)
{
    std::vector<AreaChange> changes;
    Bending bending(grid, topology, sides, changes);
    for (const BentSide& side : sides) bending.add(side);
    return changes;
}

void require_closed_cells(const MultiBlock& grid, const SubFaceJoints& joints)
{
    constexpr double round_off = 1e-11; // of the largest face, after sums over its sub-faces
    std::map<FaceKey, Vec3> changes, sums;
    for (const AreaChange& c : joints.area_changes)
        changes.try_emplace(key_of(c.block, c.axis, c.face), Vec3::Zero()).first->second += c.area;
    const auto add = [&](BlockId block, Side side, Index3 cell, const Vec3& outward) {
        if (is_high(side)) ++cell[axis_of(side)];
        sums.try_emplace(key_of(block, axis_of(side), cell), Vec3::Zero()).first->second += is_high(side) ? outward : Vec3(-outward);
    };
    for (const SubFaceInterface& f : joints.interfaces)
        for (const JoinedSubFace& s : f.faces) {
            add(f.contact.a, f.contact.side_a, s.a, s.area);
            add(f.contact.b, f.contact.side_b, s.b, -s.area);
        }
    for (const auto& [key, unused] : sums) {
        const auto [block, across, fi, fj, fk] = key;
        const Vertices& v = grid.blocks[std::size_t(block)];
        Index3 cell{fi, fj, fk};
        if (cell[across] > 0) --cell[across];
        Vec3 open = Vec3::Zero();
        double largest = 0;
        for (const Side side : all_sides) {
            Index3 face = cell;
            if (is_high(side)) ++face[axis_of(side)];
            const FaceKey at = key_of(block, axis_of(side), face);
            Vec3 area = face_shape(face_corners(v, axis_of(side), face)).area;
            if (const auto joined = sums.find(at); joined != sums.end()) area = joined->second;
            else if (const auto bent = changes.find(at); bent != changes.end()) area += bent->second;
            open += is_high(side) ? area : Vec3(-area);
            largest = std::max(largest, area.norm());
        }
        require<ConfigError>(open.norm() <= round_off * largest,
                             text("cell (", cell.i, ", ", cell.j, ", ", cell.k, ") of block ", block,
                                  " cannot be closed: its faces and sub-faces leave ", open.norm() / largest,
                                  " of a face open; let points match where curved interfaces meet, or refine there"));
    }
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/touching_blocks.hpp"
#include "core/base/error.hpp"
#include "core/grid/side_overlap.hpp"
#include "core/grid/touching_sides.hpp"
#include <algorithm>
#include <map>
#include <set>

namespace core {
namespace {

using SideKey = std::pair<BlockId, Side>;

/// Shares of the faces of a side that others cover.
struct Cover {
    int np, nq;
    std::vector<double> share;
    [[nodiscard]] double& at(FaceIndex f) { return share[std::size_t(f.p + np * f.q)]; }
};

std::map<SideKey, Cover> covers_of(const MultiBlock& grid, const std::vector<TouchingSides>& touching)
{
    std::map<SideKey, Cover> covers;
    for (const TouchingSides& t : touching) {
        const SideTiling a(grid.blocks[std::size_t(t.a)], t.side_a), b(grid.blocks[std::size_t(t.b)], t.side_b, -t.shift);
        const auto cover = [&](const SideKey& key, const SideTiling& tiling) -> Cover& {
            const auto faces = std::size_t(tiling.np() * tiling.nq());
            return covers.try_emplace(key, Cover{tiling.np(), tiling.nq(), std::vector<double>(faces, 0.0)}).first->second;
        };
        Cover &of_a = cover({t.a, t.side_a}, a), &of_b = cover({t.b, t.side_b}, b);
        for (const SubFace& f : overlap(a, b).faces) {
            of_a.at(f.master) += f.area.norm() / a.area(f.master.p, f.master.q).norm();
            of_b.at(f.other) += f.area.norm() / b.area(f.other.p, f.other.q).norm();
        }
    }
    return covers;
}

/// @throws ConfigError if it is neither.
bool is_covered(double share, const SideKey& side, FaceIndex f)
{
    constexpr double little = 0.25; // may be missing, or too much, where coarse faces lie on a curved interface
    require<ConfigError>(share < little || share > 1 - little,
                         text("side ", side_words[std::size_t(side.second)], " of block ", side.first, ": others cover ", int(100 * share),
                              " % of its face (", f.p, ", ", f.q, "); let a line of the grid run where they end"));
    return share > 0.5;
}

/// A plane of grid lines: the low faces of the cells with this index along the axis.
using Cut = std::tuple<BlockId, int, int>; // block, axis, index

/// Cuts where covered faces end. @return Is the whole side covered?
bool cut_side(const SideKey& side, Cover& cover, std::set<Cut>& cuts)
{
    const auto t = tangential_axes(side.second);
    bool wholly = true;
    for (int q = 0; q < cover.nq; ++q)
        for (int p = 0; p < cover.np; ++p) {
            const bool here = is_covered(cover.at({p, q}), side, {p, q});
            wholly = wholly && here;
            if (p > 0 && is_covered(cover.at({p - 1, q}), side, {p - 1, q}) != here) cuts.insert({side.first, t[0], p});
            if (q > 0 && is_covered(cover.at({p, q - 1}), side, {p, q - 1}) != here) cuts.insert({side.first, t[1], q});
        }
    return wholly;
}

/// Adds the cuts through blocks whose points match.
void spread(const Topology& topology, std::set<Cut>& cuts)
{
    std::vector<Cut> open(cuts.begin(), cuts.end());
    while (!open.empty()) {
        const auto [block, axis, index] = open.back();
        open.pop_back();
        for (const Side side : all_sides) {
            const auto& beyond = topology.neighbour(block, side);
            if (!beyond || axis_of(side) == axis) continue;
            Index3 above, below;
            above[axis] = index;
            below[axis] = index - 1;
            const int there = beyond->map.axis[std::size_t(axis)];
            const Cut next{beyond->block, there, std::max(beyond->map(above)[there], beyond->map(below)[there])};
            if (cuts.insert(next).second) open.push_back(next);
        }
    }
}

Vertices piece_of(const Vertices& whole, Index3 low, Index3 high)
{
    Vertices piece({high.i - low.i + 1, high.j - low.j + 1, high.k - low.k + 1}, 0, Vec3::Zero());
    for_each_cell(piece.extents(), [&](int i, int j, int k) { piece(i, j, k) = whole(low.i + i, low.j + j, low.k + k); });
    return piece;
}

void cut_blocks(MultiBlock& grid, const std::set<Cut>& cuts)
{
    std::vector<Vertices> pieces;
    std::vector<BlockId> parent;
    for (BlockId b = 0; b < BlockId(grid.blocks.size()); ++b) {
        const Vertices& whole = grid.blocks[std::size_t(b)];
        std::array<std::vector<int>, 3> ends;
        for (int axis = 0; axis < 3; ++axis) {
            ends[std::size_t(axis)].push_back(0);
            for (const auto& [block, along, index] : cuts)
                if (block == b && along == axis) ends[std::size_t(axis)].push_back(index);
            ends[std::size_t(axis)].push_back(whole.extents()[axis] - 1);
        }
        const auto& [i, j, k] = ends;
        for_each({1, 1, 1}, {int(i.size()), int(j.size()), int(k.size())}, [&](int p, int q, int r) {
            pieces.push_back(piece_of(whole, {i[std::size_t(p - 1)], j[std::size_t(q - 1)], k[std::size_t(r - 1)]},
                                      {i[std::size_t(p)], j[std::size_t(q)], k[std::size_t(r)]}));
            parent.push_back(b);
        });
    }
    grid.blocks = std::move(pieces);
    grid.boundary_name = [parent, name = grid.boundary_name](BlockId piece, Side side) { return name(parent[std::size_t(piece)], side); };
}

} // namespace

std::vector<CoveredSide> join_touching_blocks(MultiBlock& grid)
{
    constexpr int most_rounds = 20; // pieces may end on other sides than the blocks did
    std::vector<CoveredSide> covered;
    for (int round = 0; round < most_rounds; ++round) {
        grid.contacts.clear();
        const Topology topology = match_sides(grid);
        const auto touching = touching_sides(grid, topology);
        std::set<Cut> cuts;
        for (auto& [side, cover] : covers_of(grid, touching)) {
            const bool wholly = cut_side(side, cover, cuts);
            if (round == 0) covered.push_back({side.first, side.second, wholly});
        }
        if (cuts.empty()) {
            grid.contacts.assign(touching.begin(), touching.end());
            return covered;
        }
        spread(topology, cuts);
        cut_blocks(grid, cuts);
    }
    throw ConfigError("blocks that touch without matching points cannot be cut so that each side is covered as a whole");
}

} // namespace core

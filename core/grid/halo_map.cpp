// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/halo_map.hpp"
#include "core/grid/side_stencil.hpp"
#include "core/grid/side_tiling.hpp"
#include <algorithm>

namespace core {
namespace {

int layers_outside(int c, int n) { return c < 0 ? -c : c >= n ? c - n + 1 : 0; }

/// One way to a halo cell: the cell found, or those that interpolate to it.
using Way = std::vector<HaloSource>;

/// The cells that interpolate to the centres of a layer beyond a side that does not match its neighbours, straight beyond a cell
/// of the side. Layers that the block there does not have are continued linearly; layer -1 is the cell itself.
Way joined_layer(const Topology& topology, const HaloSource& cell, const SidePlace& place, int layer, LayerWeights weights)
{
    if (layer < 0) return {cell};
    if (Way way = layer_stencil(topology, place, layer, weights); !way.empty()) return way;
    Way way = joined_layer(topology, cell, place, layer - 1, weights), before = joined_layer(topology, cell, place, layer - 2, weights);
    for (auto& s : way) s.weight *= 2;
    for (auto& s : before) {
        s.weight = -s.weight;
        way.push_back(s);
    }
    return way;
}

Way beyond_joined_side(const Topology& topology, const HaloSource& at, Side side, LayerWeights weights)
{
    const int axis = axis_of(side);
    const Extents n = topology.cells[std::size_t(at.block)];
    const auto t = tangential_axes(side);
    const auto& places = topology.joints.places[std::size_t(at.block)][std::size_t(side)];
    SidePlace place = places[std::size_t(at.cell[t[0]] + n[t[0]] * at.cell[t[1]])];
    place.motion = at.motion.then(place.motion);
    HaloSource inside = at;
    inside.cell[axis] = is_high(side) ? n[axis] - 1 : 0;
    return joined_layer(topology, inside, place, layers_outside(at.cell[axis], n[axis]) - 1, weights);
}

/// How far to walk, and what interpolates at the end of it.
struct WalkRules {
    int steps;
    LayerWeights weights;
};

/// Every way of walking from `at` into the domain; those that end at a boundary give nothing.
void walk(const Topology& topology, HaloSource at, std::vector<Way>& found, WalkRules rules)
{
    const Extents n = topology.cells[std::size_t(at.block)];
    if (n.contains(at.cell)) {
        found.push_back({at});
        return;
    }
    if (rules.steps-- == 0) return;
    int outside = 0;
    for (int m = 0; m < 3; ++m) outside += layers_outside(at.cell[m], n[m]) > 0;
    for (int m = 0; m < 3; ++m) {
        if (layers_outside(at.cell[m], n[m]) == 0) continue;
        const Side side = side_of(m, at.cell[m] >= 0);
        const auto& beyond = topology.neighbour(at.block, side);
        if (beyond) walk(topology, {beyond->block, beyond->map(at.cell), at.motion.then(beyond->motion), 1}, found, rules);
        else if (outside == 1 && topology.joints.joins(at.block, side))
            found.push_back(beyond_joined_side(topology, at, side, rules.weights));
    }
}

bool same_cell(const HaloSource& a, const HaloSource& b) { return a.block == b.block && a.cell == b.cell && a.motion.is_same(b.motion); }

bool same(const Way& a, const Way& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_cell); }

/// Ways to a cell that all begin in `block`; none if each of them ends at a boundary.
std::vector<Way> ways_to(const Topology& topology, BlockId block, Index3 cell, WalkRules rules)
{
    std::vector<Way> found, some;
    walk(topology, {block, cell, Motion(), 1}, found, rules);
    for (auto& way : found)
        if (std::none_of(some.begin(), some.end(), [&](const Way& other) { return same(way, other); })) some.push_back(std::move(way));
    std::sort(some.begin(), some.end(), [](const Way& a, const Way& b) {
        const HaloSource &first = a.front(), &second = b.front();
        return std::tuple(first.block, first.cell.k, first.cell.j, first.cell.i) <
               std::tuple(second.block, second.cell.k, second.cell.j, second.cell.i);
    });
    return some;
}

/// The mean of some ways, each with a weight.
void add_mean(const std::vector<Way>& ways, double weight, std::vector<HaloSource>& sources)
{
    for (const Way& way : ways)
        for (HaloSource s : way) {
            s.weight *= weight * (1.0 / double(ways.size()));
            sources.push_back(s);
        }
}

/// Beyond a re-entrant edge of the domain, such as the edge of a step, there is no cell, and no wall of this block that would
/// mirror one: what lies there is continued linearly from beyond the two sides and from this block; hats take the mean of the sides.
std::vector<HaloSource> continued(const Topology& topology, BlockId block, Index3 cell, WalkRules rules)
{
    const Extents n = topology.cells[std::size_t(block)];
    std::vector<int> outside;
    for (int m = 0; m < 3; ++m) {
        if (layers_outside(cell[m], n[m]) == 0) continue;
        if (topology.at_boundary(block, side_of(m, cell[m] >= 0))) return {};
        outside.push_back(m);
    }
    const auto inward = [&](Index3 c, int m) {
        c[m] = std::clamp(c[m], 0, n[m] - 1);
        return c;
    };
    for (std::size_t first = 0; first < outside.size(); ++first)
        for (std::size_t second = first + 1; second < outside.size(); ++second) {
            const Index3 one = inward(cell, outside[first]), two = inward(cell, outside[second]), both = inward(one, outside[second]);
            std::vector<HaloSource> all;
            bool complete = true;
            const double side = rules.weights == LayerWeights::cubic ? 1.0 : 0.5;
            for (const auto& [at, sign] : {std::pair(one, side), std::pair(two, side), std::pair(both, 1 - 2 * side)}) {
                if (sign == 0) continue;
                const auto ways = ways_to(topology, block, at, rules);
                complete = complete && !ways.empty();
                add_mean(ways, sign, all);
            }
            if (complete) return all;
        }
    return {};
}

} // namespace

std::vector<HaloRow> halo_rows(const Topology& topology, BlockId block, int width, HaloShape shape)
{
    const Extents n = topology.cells[std::size_t(block)];
    const WalkRules rules{3 * (width + 1), shape == HaloShape::hats ? LayerWeights::linear : LayerWeights::cubic};
    std::vector<HaloRow> rows;
    for_each({-width, -width, -width}, {n.ni + width, n.nj + width, n.nk + width}, [&](int i, int j, int k) {
        const int outside = (layers_outside(i, n.ni) > 0) + (layers_outside(j, n.nj) > 0) + (layers_outside(k, n.nk) > 0);
        if (outside == 0 || (shape == HaloShape::faces && outside > 1)) return;
        const auto ways = ways_to(topology, block, {i, j, k}, rules);
        HaloRow row{{i, j, k}, {}, ways.size() != 1};
        add_mean(ways, 1, row.sources);
        if (ways.empty() && outside > 1) row.sources = continued(topology, block, row.cell, rules);
        if (!row.sources.empty()) rows.push_back(std::move(row));
    });
    return rows;
}

} // namespace core

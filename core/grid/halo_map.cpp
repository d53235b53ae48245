// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/halo_map.hpp"
#include <algorithm>

namespace core {
namespace {

int layers_outside(int c, int n) { return c < 0 ? -c : c >= n ? c - n + 1 : 0; }

/// Every way of walking from `at` into the domain; those that end at a boundary give nothing.
void walk(const Topology& topology, HaloSource at, std::vector<HaloSource>& found, int steps)
{
    const Extents n = topology.cells[std::size_t(at.block)];
    if (n.contains(at.cell)) {
        found.push_back(at);
        return;
    }
    if (steps == 0) return;
    for (int m = 0; m < 3; ++m) {
        if (layers_outside(at.cell[m], n[m]) == 0) continue;
        const auto& beyond = topology.neighbour(at.block, side_of(m, at.cell[m] >= 0));
        if (beyond) walk(topology, {beyond->block, beyond->map(at.cell), at.shift + beyond->shift, 1}, found, steps - 1);
    }
}

bool same(const HaloSource& a, const HaloSource& b)
{
    return a.block == b.block && a.cell == b.cell && (a.shift - b.shift).norm() < 1e-9 * (1 + a.shift.norm());
}

std::vector<HaloSource> unique(const std::vector<HaloSource>& all)
{
    std::vector<HaloSource> some;
    for (const auto& s : all)
        if (std::none_of(some.begin(), some.end(), [&](const HaloSource& t) { return same(s, t); })) some.push_back(s);
    std::sort(some.begin(), some.end(), [](const HaloSource& a, const HaloSource& b) {
        return std::tuple(a.block, a.cell.k, a.cell.j, a.cell.i) < std::tuple(b.block, b.cell.k, b.cell.j, b.cell.i);
    });
    for (auto& s : some) s.weight = 1.0 / double(some.size());
    return some;
}

/// Ways to a cell that all begin in `block`; none if each of them ends at a boundary.
std::vector<HaloSource> ways_to(const Topology& topology, BlockId block, Index3 cell, int longest_walk)
{
    std::vector<HaloSource> found;
    walk(topology, {block, cell, Vec3::Zero(), 1}, found, longest_walk);
    return unique(found);
}

/// Beyond a re-entrant edge of the domain, such as the edge of a step, there is no cell, and no wall of this block that would
/// mirror one: what lies there is continued linearly from beyond the two sides and from this block.
std::vector<HaloSource> continued(const Topology& topology, BlockId block, Index3 cell, int longest_walk)
{
    const Extents n = topology.cells[std::size_t(block)];
    std::vector<int> outside;
    for (int m = 0; m < 3; ++m) {
        if (layers_outside(cell[m], n[m]) == 0) continue;
        if (!topology.neighbour(block, side_of(m, cell[m] >= 0))) return {};
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
            for (const auto& [at, sign] : {std::pair(one, 1.0), std::pair(two, 1.0), std::pair(both, -1.0)}) {
                const auto ways = ways_to(topology, block, at, longest_walk);
                complete = complete && !ways.empty();
                for (HaloSource s : ways) {
                    s.weight *= sign;
                    all.push_back(s);
                }
            }
            if (complete) return all;
        }
    return {};
}

} // namespace

std::vector<HaloRow> halo_rows(const Topology& topology, BlockId block, int width, HaloShape shape)
{
    const Extents n = topology.cells[std::size_t(block)];
    const int longest_walk = 3 * (width + 1);
    std::vector<HaloRow> rows;
    for_each({-width, -width, -width}, {n.ni + width, n.nj + width, n.nk + width}, [&](int i, int j, int k) {
        const int outside = (layers_outside(i, n.ni) > 0) + (layers_outside(j, n.nj) > 0) + (layers_outside(k, n.nk) > 0);
        if (outside == 0 || (shape == HaloShape::faces && outside > 1)) return;
        auto sources = ways_to(topology, block, {i, j, k}, longest_walk);
        if (sources.empty() && outside > 1) sources = continued(topology, block, {i, j, k}, longest_walk);
        if (!sources.empty()) rows.push_back({{i, j, k}, sources});
    });
    return rows;
}

} // namespace core

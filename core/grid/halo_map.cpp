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

} // namespace

std::vector<HaloRow> halo_rows(const Topology& topology, BlockId block, int width, HaloShape shape)
{
    const Extents n = topology.cells[std::size_t(block)];
    const int longest_walk = 3 * (width + 1);
    std::vector<HaloRow> rows;
    for_each({-width, -width, -width}, {n.ni + width, n.nj + width, n.nk + width}, [&](int i, int j, int k) {
        const int outside = (layers_outside(i, n.ni) > 0) + (layers_outside(j, n.nj) > 0) + (layers_outside(k, n.nk) > 0);
        if (outside == 0 || (shape == HaloShape::faces && outside > 1)) return;
        std::vector<HaloSource> found;
        walk(topology, {block, {i, j, k}, Vec3::Zero(), 1}, found, longest_walk);
        if (!found.empty()) rows.push_back({{i, j, k}, unique(found)});
    });
    return rows;
}

} // namespace core

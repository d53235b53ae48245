// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/quality.hpp"
#include "core/grid/cell_edges.hpp"
#include "core/grid/hexahedron.hpp"
#include <cmath>
#include <limits>

namespace core {
namespace {

/// Largest |cosine| between two edges that leave a corner.
double largest_cosine(const Vertices& v, Index3 c)
{
    double largest = 0;
    for_each({0, 0, 0}, {2, 2, 2}, [&](int i, int j, int k) {
        std::array<Vec3, 3> edge;
        for (int m = 0; m < 3; ++m) {
            Index3 low{c.i + i, c.j + j, c.k + k}, high = low;
            low[m] = c[m];
            high[m] = c[m] + 1;
            edge[std::size_t(m)] = (v.view()[high] - v.view()[low]).normalized();
        }
        for (std::size_t m = 0; m < 3; ++m) largest = std::max(largest, std::abs(edge[m].dot(edge[(m + 1) % 3])));
    });
    return std::min(largest, 1.0);
}

void take_larger(WorstCell& worst, double value, BlockId block, Index3 cell)
{
    if (value > worst.value) worst = {value, block, cell};
}

/// Ratio of the sizes of a cell and the one beyond one of its sides along the line that joins them; 1 at a boundary.
double growth_beyond(const std::vector<Vertices>& blocks, const Topology& topology, BlockId block, Index3 c, Side side)
{
    int axis = axis_of(side);
    const double here = mean_edges(blocks[std::size_t(block)], c)[axis];
    c[axis] += is_high(side) ? 1 : -1;
    if (!topology.cells[std::size_t(block)].contains(c)) {
        const auto& beyond = topology.neighbour(block, side);
        if (!beyond) return 1;
        c = beyond->map(c);
        axis = axis_of(beyond->side);
        block = beyond->block;
    }
    const double there = mean_edges(blocks[std::size_t(block)], c)[axis];
    return std::max(here / there, there / here);
}

} // namespace

GridQuality quality_of(const std::vector<Vertices>& blocks, const Topology& topology)
{
    GridQuality q;
    q.jacobian.value = std::numeric_limits<double>::infinity();
    q.skewness.value = q.growth.value = q.aspect_ratio.value = -1;
    for (BlockId b = 0; b < BlockId(blocks.size()); ++b) {
        const Vertices& v = blocks[std::size_t(b)];
        for_each_cell(cells_of(v), [&](int i, int j, int k) {
            const Index3 c{i, j, k};
            const double jacobian = smallest_corner_jacobian(v, c);
            if (jacobian < q.jacobian.value) q.jacobian = {jacobian, b, c};
            take_larger(q.skewness, std::asin(largest_cosine(v, c)), b, c);
            const Vec3 edges = mean_edges(v, c);
            take_larger(q.aspect_ratio, edges.maxCoeff() / edges.minCoeff(), b, c);
            for (const Side side : all_sides) take_larger(q.growth, growth_beyond(blocks, topology, b, c, side), b, c);
        });
    }
    return q;
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A box of rectangular cells, cut into blocks, with a void fraction that varies: the measuring stick of pressure solvers.
#include "tests/support/conduction_problem.hpp"
#include <array>
#include <functional>

namespace test {

/// Vertices along the three axes, numbers of blocks, and the axes that are periodic.
struct BoxGrid {
    std::array<std::vector<double>, 3> vertices;
    std::array<int, 3> blocks{1, 1, 1};
    std::array<bool, 3> periodic{false, false, false};
    [[nodiscard]] int cells(int axis) const { return int(vertices[std::size_t(axis)].size()) - 1; }
    [[nodiscard]] double width(int axis, int n) const
    {
        const auto& x = vertices[std::size_t(axis)];
        return x[std::size_t(n) + 1] - x[std::size_t(n)];
    }
    [[nodiscard]] double centre(int axis, int n) const
    {
        const auto& x = vertices[std::size_t(axis)];
        return 0.5 * (x[std::size_t(n) + 1] + x[std::size_t(n)]);
    }
};

[[nodiscard]] inline std::vector<double> uniform(int n, double length)
{
    std::vector<double> x;
    for (int i = 0; i <= n; ++i) x.push_back(length * i / n);
    return x;
}

/// n cells between walls at 0 and 1, narrowing towards both: the stretching that makes the first cell `first` wide.
[[nodiscard]] inline std::vector<double> between_walls(int n, double first)
{
    const auto vertex = [n](double s, int i) { return 0.5 * (1.0 + std::tanh(s * (2.0 * i / n - 1.0)) / std::tanh(s)); };
    double low = 0.01, high = 20.0;
    while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (vertex(middle, 1) > first ? low : high) = middle;
    }
    std::vector<double> y;
    for (int i = 0; i <= n; ++i) y.push_back(vertex(low, i));
    return y;
}

/// Smooth variation between 0.36 and 1, and spheres of 0.36 with a sudden edge.
[[nodiscard]] inline double bed_and_spheres(double x, double y, double z)
{
    const double smooth = 0.68 + 0.32 * std::sin(5.1 * x + 1.0) * std::cos(4.3 * y) * std::sin(3.7 * z + 0.5);
    const auto inside = [=](double a, double b, double c, double r) {
        return (x - a) * (x - a) + (y - b) * (y - b) + (z - c) * (z - c) < r * r;
    };
    return inside(0.3, 0.4, 0.5, 0.2) || inside(0.8, 0.6, 0.4, 0.15) ? 0.36 : smooth;
}

using CellValue = std::function<double(double, double, double)>;

/// Two-point transmissibilities: area over the sum of (half a width over value) of the two cells.
[[nodiscard]] inline ConductionProblem box_problem(const BoxGrid& g, const CellValue& value = bed_and_spheres)
{
    const auto first = [&](int axis, int block) { return g.cells(axis) * block / g.blocks[std::size_t(axis)]; };
    const auto id = [&](core::Index3 b) { return b.i + g.blocks[0] * (b.j + g.blocks[1] * b.k); };
    const core::Extents blocks{g.blocks[0], g.blocks[1], g.blocks[2]};
    std::vector<core::Extents> cells;
    core::for_each_cell(blocks, [&](int i, int j, int k) {
        cells.push_back({first(0, i + 1) - first(0, i), first(1, j + 1) - first(1, j), first(2, k + 1) - first(2, k)});
    });
    ConductionProblem p(cells);
    const auto at = [&](core::Index3 c) { return value(g.centre(0, c.i), g.centre(1, c.j), g.centre(2, c.k)); };
    const auto between = [&](int axis, core::Index3 a, core::Index3 b) { // global cells a and b, neighbours along axis
        double area = 1.0;
        for (int other = 0; other < 3; ++other)
            if (other != axis) area *= g.width(other, a[other]);
        return area / (0.5 * g.width(axis, a[axis]) / at(a) + 0.5 * g.width(axis, b[axis]) / at(b));
    };
    core::for_each_cell(blocks, [&](int bi, int bj, int bk) {
        const core::Index3 place{bi, bj, bk};
        const int block = id(place);
        const auto n = cells[std::size_t(block)];
        core::for_each_cell(n, [&](int i, int j, int k) {
            const core::Index3 here{first(0, bi) + i, first(1, bj) + j, first(2, bk) + k};
            for (int axis = 0; axis < 3; ++axis) {
                const core::Index3 local{i, j, k};
                core::Index3 below = here;
                below[axis] -= 1;
                if (local[axis] > 0) {
                    p.face.on(block).along(axis)[local] = between(axis, below, here);
                    continue;
                }
                if (below[axis] < 0 && !g.periodic[std::size_t(axis)]) continue;
                below[axis] = (below[axis] + g.cells(axis)) % g.cells(axis);
                core::Index3 neighbour = place, other = local;
                neighbour[axis] = (place[axis] + blocks[axis] - 1) % blocks[axis];
                const auto m = cells[std::size_t(id(neighbour))];
                other[axis] = m[axis] - 1;
                p.topology.links.push_back({{block, physics::cell_index(n, i, j, k), core::side_of(axis, false)},
                                            {id(neighbour), physics::cell_index(m, other.i, other.j, other.k), core::side_of(axis, true)}});
                p.link.push_back(between(axis, below, here));
            }
        });
    });
    return p;
}

} // namespace test

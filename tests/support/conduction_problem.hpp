// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Conduction problems on sets of blocks, for the tests of the linear solvers: boxes, channels, random block sets.
#include "core/field/field.hpp"
#include "physics/fluid/seven_point_solver.hpp"
#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

namespace test {

struct ConductionProblem {
    physics::BlockTopology topology;
    core::FaceField face;
    std::vector<double> link;
    core::ScalarField shift;

    explicit ConductionProblem(const std::vector<core::Extents>& cells)
        : topology{cells, std::vector<int>(cells.size(), 0), 0, {}},
          face({"transmissibility", "m3/(s Pa)", 0, true}, cells),
          shift({"shift", "m3/(s Pa)", 0, true}, cells)
    {
        face.allocate();
        shift.allocate();
    }
    [[nodiscard]] physics::Coefficients coefficients(bool with_shift = false) const { return {&face, link, with_shift ? &shift : nullptr}; }
    /// Row of the dense matrix of a cell.
    [[nodiscard]] Eigen::Index row(core::BlockId block, int cell) const
    {
        Eigen::Index n = cell;
        for (core::BlockId b = 0; b < block; ++b) n += topology.cells[std::size_t(b)].size();
        return n;
    }
    /// body(row, column, addend) for the whole matrix, in the plainest way.
    template <class Body>
    void for_each_entry(bool with_shift, Body body) const
    {
        const auto couple = [&](Eigen::Index r, Eigen::Index c, double t) {
            body(r, r, t);
            body(c, c, t);
            body(r, c, -t);
            body(c, r, -t);
        };
        for (int b = 0; b < int(topology.cells.size()); ++b) {
            const auto n = topology.cells[std::size_t(b)];
            core::for_each_cell(n, [&](int i, int j, int k) {
                const auto r = row(b, physics::cell_index(n, i, j, k));
                if (i > 0) couple(r, r - 1, face.on(b).i(i, j, k));
                if (j > 0) couple(r, r - n.ni, face.on(b).j(i, j, k));
                if (k > 0) couple(r, r - n.ni * n.nj, face.on(b).k(i, j, k));
                if (with_shift) body(r, r, shift.on(b)(i, j, k));
            });
        }
        for (std::size_t l = 0; l < link.size(); ++l) {
            const auto& [ea, eb] = topology.links[l];
            if (eb.block == physics::wall_block) body(row(ea.block, ea.cell), row(ea.block, ea.cell), link[l]);
            else couple(row(ea.block, ea.cell), row(eb.block, eb.cell), link[l]);
        }
    }
    [[nodiscard]] Eigen::MatrixXd dense(bool with_shift = false) const
    {
        const auto size = Eigen::Index(physics::cell_count(topology));
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
        for_each_entry(with_shift, [&](Eigen::Index r, Eigen::Index c, double addend) { a(r, c) += addend; });
        return a;
    }
};

/// Calls body(value) for every transmissibility of the blocks, boundary faces included.
template <class Body>
void for_each_coefficient(ConductionProblem& p, Body body)
{
    for (int b = 0; b < int(p.topology.cells.size()); ++b)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (double& t : p.face.data(b, axis)) body(t);
}

/// Connects two sides with the same number of cells, tangential axes in order.
inline void connect(ConductionProblem& p, core::BlockId a, core::Side side_a, core::BlockId b, core::Side side_b, double t)
{
    const auto on_side = [&](core::BlockId block, core::Side side, int u, int v) {
        const auto n = p.topology.cells[std::size_t(block)];
        const int axis = axis_of(side), first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
        core::Index3 c;
        c[axis] = is_high(side) ? n[axis] - 1 : 0;
        c[first] = u;
        c[second] = v;
        return physics::LinkEnd{block, physics::cell_index(n, c.i, c.j, c.k), side};
    };
    const auto n = p.topology.cells[std::size_t(a)];
    const int axis = axis_of(side_a);
    for (int v = 0; v < n[axis == 2 ? 1 : 2]; ++v)
        for (int u = 0; u < n[axis == 0 ? 1 : 0]; ++u) {
            p.topology.links.push_back({on_side(a, side_a, u, v), on_side(b, side_b, u, v)});
            p.link.push_back(t);
        }
}

/// Blocks of random sizes, randomly tied by links (any cell of a side to any cell of another, also of the same block),
/// with random coefficients within a factor of `jump`. The blocks form one connected body.
inline ConductionProblem random_blocks(unsigned seed, double jump)
{
    std::mt19937 random(seed);
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    std::vector<core::Extents> cells;
    for (int b = 0; b < 4; ++b) cells.push_back({1 + below(6), 2 + below(5), 1 + below(6)});
    ConductionProblem p(cells);
    const auto value = [&] { return std::exp(std::log(jump) * (below(1001) / 1000.0)); };
    for_each_coefficient(p, [&](double& t) { t = value(); });
    for (int b = 0; b < 4; ++b)
        for (double& s : p.shift.data(b, 0)) s = value();
    const auto end = [&](int b) {
        const auto n = cells[std::size_t(b)];
        const auto side = core::all_sides[std::size_t(below(6))];
        core::Index3 c{below(n.ni), below(n.nj), below(n.nk)};
        c[axis_of(side)] = is_high(side) ? n[axis_of(side)] - 1 : 0;
        return physics::LinkEnd{b, physics::cell_index(n, c.i, c.j, c.k), side};
    };
    for (int l = 0; l < 60; ++l) {
        p.topology.links.push_back({end(l % 4), end(l < 4 ? (l + 1) % 4 : below(4))});
        p.link.push_back(value());
    }
    return p;
}

/// The part of a problem that one rank of several sees.
inline ConductionProblem part_of(const ConductionProblem& whole, const std::vector<int>& owner, int rank)
{
    std::vector<core::Extents> own;
    std::vector<int> ids;
    for (int b = 0; b < int(owner.size()); ++b)
        if (owner[std::size_t(b)] == rank) {
            own.push_back(whole.topology.cells[std::size_t(b)]);
            ids.push_back(b);
        }
    ConductionProblem part(own);
    for (int b = 0; b < int(ids.size()); ++b) {
        for (std::size_t axis = 0; axis < 3; ++axis) part.face.data(b, axis) = whole.face.data(ids[std::size_t(b)], axis);
        part.shift.data(b, 0) = whole.shift.data(ids[std::size_t(b)], 0);
    }
    part.topology = {whole.topology.cells, owner, rank, {}};
    for (std::size_t l = 0; l < whole.link.size(); ++l) {
        const auto& link = whole.topology.links[l];
        if (owner[std::size_t(link.a.block)] != rank && owner[std::size_t(link.b.block)] != rank) continue;
        part.topology.links.push_back(link);
        part.link.push_back(whole.link[l]);
    }
    return part;
}

/// A flat array from the rows of a dense vector, and back.
inline std::vector<double> flat(const ConductionProblem& p, const physics::BlockLayout& layout, const Eigen::VectorXd& rows)
{
    std::vector<double> values(layout.size(), 0.0);
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size(); ++c)
            values[std::size_t(layout.origin(b) + c)] = rows[p.row(layout.id(b), int(c))];
    return values;
}
inline Eigen::VectorXd rows(const ConductionProblem& p, const physics::BlockLayout& layout, std::span<const double> flat)
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(Eigen::Index(physics::cell_count(p.topology)));
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size(); ++c)
            result[p.row(layout.id(b), int(c))] = flat[std::size_t(layout.origin(b) + c)];
    return result;
}

/// Random numbers in [-1, 1] with zero mean, at the cells of a layout.
inline std::vector<double> random_right(const physics::BlockLayout& layout, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<double> values(layout.size(), 0.0);
    double sum = 0.0;
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size(); ++c)
            sum += values[std::size_t(layout.origin(b) + c)] = double(random()) / 2147483648.0 - 1.0;
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size(); ++c)
            values[std::size_t(layout.origin(b) + c)] -= sum / double(layout.cell_count());
    return values;
}

} // namespace test

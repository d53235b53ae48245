// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/graph_level.hpp"

#include "physics/fluid/aggregation.hpp"
#include "physics/fluid/multigrid_smoother.hpp"

namespace physics {
namespace {

/// A level as PairwiseAggregation wants it.
struct GraphOfLevel {
    const GraphMatrix& matrix;
    std::vector<double> sums;

    explicit GraphOfLevel(const GraphMatrix& m) : matrix(m)
    {
        for (int n = 0; n < m.nodes(); ++n) {
            double sum = m.shift[std::size_t(n)];
            for_each(n, [&](int, double t) { sum += t; });
            sums.push_back(sum);
        }
    }
    [[nodiscard]] int nodes() const { return matrix.nodes(); }
    [[nodiscard]] double sum(int n) const { return sums[std::size_t(n)]; }
    [[nodiscard]] double shift(int n) const { return matrix.shift[std::size_t(n)]; }
    template <class Body>
    void for_each(int n, Body body) const
    {
        for (int e = matrix.first[std::size_t(n)]; e < matrix.first[std::size_t(n) + 1]; ++e)
            body(matrix.other[std::size_t(e)], double(matrix.conductance[std::size_t(e)]));
    }
};

GraphMatrix coarse_matrix(const GraphMatrix& fine, const std::vector<int>& parent, int count)
{
    const NodesOfAggregates nodes(parent, 0, count);
    GraphMatrix coarse;
    coarse.first.push_back(0);
    GraphRow row;
    for (int p = 0; p < count; ++p) {
        row.start(p);
        nodes.for_each(p, [&](int n) {
            row.hold(fine.shift[std::size_t(n)]);
            for (int e = fine.first[std::size_t(n)]; e < fine.first[std::size_t(n) + 1]; ++e)
                row.tie(parent[std::size_t(fine.other[std::size_t(e)])], fine.conductance[std::size_t(e)]);
        });
        row.append_to(coarse);
    }
    coarse.shrink_to_fit();
    return coarse;
}

template <class Body>
void for_nodes(const core::Team& team, const GraphLevel& level, Body body)
{
    core::for_chunks(team, level.matrix.nodes(), GraphLevel::grain, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) body(std::size_t(n));
    });
}

auto steps() { return chebyshev_steps<2>(2.0, 6.0); }

void take(const core::Team& team, const ChebyshevStep& step, GraphLevel& level)
{
    for_nodes(team, level, [&](std::size_t n) {
        level.direction[n] = step.keep * level.direction[n] + step.gain * (level.inverse[n] * level.residual[n]);
        level.solution[n] += level.direction[n];
    });
}

} // namespace

GraphLevel::GraphLevel(GraphMatrix m) : matrix(std::move(m))
{
    const auto nodes = std::size_t(matrix.nodes());
    for (auto* v : {&inverse, &right, &residual, &direction, &solution}) v->assign(nodes, 0.0F);
    for (std::size_t n = 0; n < nodes; ++n) {
        float sum = matrix.shift[n];
        for (int e = matrix.first[n]; e < matrix.first[n + 1]; ++e) sum += matrix.conductance[std::size_t(e)];
        inverse[n] = sum > 0.0F ? 1.0F / sum : 0.0F;
    }
}

void GraphLevel::expect_two_visits()
{
    first_solution.assign(solution.size(), 0.0F);
    first_image.assign(solution.size(), 0.0F);
    parts.assign((solution.size() + grain - 1) / grain, 0.0);
}

std::size_t GraphLevel::bytes() const
{
    std::size_t vectors = 5 * inverse.capacity() + first_solution.capacity() + first_image.capacity();
    return matrix.bytes() + parent.capacity() * sizeof(int) + vectors * sizeof(float) + parts.capacity() * sizeof(double);
}

void form_residual(const core::Team& team, GraphLevel& level)
{
    const GraphMatrix& a = level.matrix;
    for_nodes(team, level, [&](std::size_t n) {
        const float x = level.solution[n];
        float sum = a.shift[n] * x;
        for (int e = a.first[n]; e < a.first[n + 1]; ++e)
            sum += a.conductance[std::size_t(e)] * (x - level.solution[std::size_t(a.other[std::size_t(e)])]);
        level.residual[n] = level.right[n] - sum;
    });
}

void smooth_from_zero(const core::Team& team, GraphLevel& level)
{
    for_nodes(team, level, [&](std::size_t n) {
        level.direction[n] = level.solution[n] = 0.0F;
        level.residual[n] = level.right[n];
    });
    const auto all = steps();
    take(team, all.front(), level);
    for (std::size_t s = 1; s < all.size(); ++s) {
        form_residual(team, level);
        take(team, all[s], level);
    }
}

void smooth(const core::Team& team, GraphLevel& level)
{
    for (const ChebyshevStep& step : steps()) {
        form_residual(team, level);
        take(team, step, level);
    }
}

void restrict_residual(const GraphLevel& fine, GraphLevel& coarse)
{
    std::fill(coarse.right.begin(), coarse.right.end(), 0.0F);
    for (std::size_t n = 0; n < fine.parent.size(); ++n)
        if (fine.parent[n] >= 0) coarse.right[std::size_t(fine.parent[n])] += fine.residual[n];
}

void add_correction(const GraphLevel& coarse, float gain, GraphLevel& fine)
{
    for (std::size_t n = 0; n < fine.parent.size(); ++n)
        if (fine.parent[n] >= 0) fine.solution[n] += gain * coarse.solution[std::size_t(fine.parent[n])];
}

GraphLevel coarsened(GraphLevel& fine)
{
    constexpr double bound = 10.0, largest_bound = 1e3, enough = 0.6; // share of the nodes that may be left
    const GraphOfLevel graph(fine.matrix);
    Aggregates joined;
    for (double b = bound; b < largest_bound; b *= 2) { // where hardly anything holds together, less must do
        joined = PairwiseAggregation(graph, b).joined();
        if (joined.count <= enough * fine.matrix.nodes()) break;
    }
    fine.parent = std::move(joined.parent);
    return GraphLevel(coarse_matrix(fine.matrix, fine.parent, joined.count));
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/aggregation.hpp"
#include "tests/support/conduction_jumps.hpp"
#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>

namespace {

/// Random ties, as a graph for PairwiseAggregation.
struct DenseGraph {
    Eigen::MatrixXd ties;
    std::vector<double> held;

    [[nodiscard]] int nodes() const { return int(ties.rows()); }
    [[nodiscard]] double shift(int n) const { return held[std::size_t(n)]; }
    [[nodiscard]] double sum(int n) const { return ties.row(n).sum() + shift(n); }
    template <class Body>
    void for_each(int n, Body body) const
    {
        for (int m = 0; m < nodes(); ++m)
            if (ties(n, m) > 0) body(m, ties(n, m));
    }
};

DenseGraph random_graph(int nodes, int seed, double jump)
{
    DenseGraph g{Eigen::MatrixXd::Zero(nodes, nodes), std::vector<double>(std::size_t(nodes), 0.0)};
    for (int m = 0; m < nodes; ++m)
        for (int n = 0; n < m; ++n)
            if (test::scattered(m, n, seed) < 0.4) g.ties(m, n) = g.ties(n, m) = std::pow(jump, test::scattered(n, m, seed + 1000));
    return g;
}

/// Twice the largest ratio of the two sums of holds_together(), from the eigenvalues of the dense pencil.
double condition(const DenseGraph& g, const std::vector<int>& nodes)
{
    const auto n = Eigen::Index(nodes.size());
    Eigen::MatrixXd ties(n, n);
    Eigen::VectorXd d(n);
    for (Eigen::Index r = 0; r < n; ++r) {
        d[r] = g.sum(nodes[std::size_t(r)]);
        for (Eigen::Index c = 0; c < n; ++c) ties(r, c) = g.ties(nodes[std::size_t(r)], nodes[std::size_t(c)]);
    }
    Eigen::MatrixXd laplacian = -ties;
    laplacian.diagonal() += ties.rowwise().sum();
    const Eigen::MatrixXd weights = d.asDiagonal();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> pencil(laplacian, weights);
    return 2.0 / std::max(pencil.eigenvalues()[1], 1e-300); // the first belongs to constants
}

} // namespace

TEST_CASE("aggregates hold together as their eigenvalues say, and no node is in two")
{
    int joined_nodes = 0;
    for (int seed = 1; seed <= 40; ++seed) {
        const auto g = random_graph(30, seed, 1e-5);
        constexpr double bound = 10.0;
        const auto joined = physics::PairwiseAggregation(g, bound).joined();
        std::vector<std::vector<int>> members(std::size_t(joined.count));
        for (int n = 0; n < g.nodes(); ++n)
            if (joined.parent[std::size_t(n)] >= 0) members[std::size_t(joined.parent[std::size_t(n)])].push_back(n);
        for (const auto& nodes : members) {
            REQUIRE(!nodes.empty());
            CHECK(nodes.size() <= physics::most_joined);
            if (nodes.size() < 2) continue;
            joined_nodes += int(nodes.size());
            CHECK(condition(g, nodes) <= bound * 1.001); // round-off of 1e-6 of the pivots is let pass
        }
    }
    CHECK(joined_nodes > 100); // the test has something to judge
}

TEST_CASE("a chain of four equal cells is refused where a square is not")
{
    // In three dimensions each cell has six ties. Chain: 2 * 6 / (2 - sqrt 2) = 20.5; square: 2 * 6 / 2 = 6.
    const std::array<double, 4> sums{6, 6, 6, 6};
    physics::AggregateTies chain{}, square{};
    for (std::size_t n = 0; n + 1 < 4; ++n) chain[n][n + 1] = chain[n + 1][n] = square[n][n + 1] = square[n + 1][n] = 1.0;
    square[0][3] = square[3][0] = 1.0;
    CHECK(!physics::holds_together(sums, chain, 20.0));
    CHECK(physics::holds_together(sums, chain, 21.0));
    CHECK(!physics::holds_together(sums, square, 5.9));
    CHECK(physics::holds_together(sums, square, 6.1));
}

TEST_CASE("nodes that are held firmly are left out")
{
    auto g = random_graph(10, 7, 0.5);
    g.held[3] = g.ties.row(3).sum();
    const auto joined = physics::PairwiseAggregation(g, 10.0).joined();
    CHECK(joined.parent[3] == -1);
    CHECK(joined.parent[4] >= 0);
}

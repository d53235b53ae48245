// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "tests/support/conduction_problem.hpp"
#include <doctest/doctest.h>

namespace {

const core::SerialTeam serial;

/// Largest difference of two vectors, means removed, over the largest value.
double difference_up_to_a_constant(Eigen::VectorXd a, Eigen::VectorXd b)
{
    a.array() -= a.mean();
    b.array() -= b.mean();
    return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

} // namespace

TEST_CASE("the 7-point operator with links is the assembled matrix")
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const auto p = test::random_blocks(seed, 1e3);
        physics::SevenPointSolver solver(p.topology, {.shifted = true, .singular = false});
        solver.copy(serial, p.coefficients(true));
        const auto x = test::random_right(solver.layout(), seed);
        std::vector<double> y(solver.layout().size());
        solver.apply(serial, x, y);
        const Eigen::VectorXd expected = p.dense(true) * test::rows(p, solver.layout(), x);
        // The two differ by the order of some ten additions.
        CHECK((test::rows(p, solver.layout(), y) - expected).norm() < 1e-14 * expected.norm());
    }
}

TEST_CASE("a singular system on random blocks has the solution of a dense factorisation")
{
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const auto p = test::random_blocks(seed, 1e3);
        physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30});
        solver.set_up(serial, p.coefficients());
        auto right = test::random_right(solver.layout(), seed);
        const Eigen::VectorXd b = test::rows(p, solver.layout(), right);
        std::vector<double> x(solver.layout().size(), 0.0);
        const auto report = solver.solve(serial, {.relative = 1e-11, .most_iterations = 500, .singular = true}, right, x);
        Eigen::MatrixXd a = p.dense();
        a(0, 0) *= 2.0;
        const Eigen::VectorXd expected = a.ldlt().solve(b);
        // Condition numbers are about 1e5, residuals 1e-11.
        CHECK(difference_up_to_a_constant(test::rows(p, solver.layout(), x), expected) < 1e-6);
        // Links at random make no mesh: nothing is promised about the number of iterations.
        CHECK(report.residuals.back() <= 1e-11 * report.right_norm);
    }
}

TEST_CASE("a shifted system on random blocks has the solution of a dense factorisation")
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const auto p = test::random_blocks(seed, 1e2);
        physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30, .shifted = true, .singular = false});
        solver.set_up(serial, p.coefficients(true));
        auto right = test::random_right(solver.layout(), seed);
        const Eigen::VectorXd b = test::rows(p, solver.layout(), right);
        std::vector<double> x(solver.layout().size(), 0.0);
        (void)solver.solve(serial, {.relative = 1e-12, .most_iterations = 500}, right, x);
        const Eigen::VectorXd expected = p.dense(true).ldlt().solve(b);
        // Condition numbers are about 1e3, residuals 1e-12.
        CHECK((test::rows(p, solver.layout(), x) - expected).norm() < 1e-9 * expected.norm());
    }
}

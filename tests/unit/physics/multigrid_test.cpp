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

TEST_CASE("the V-cycle is symmetric and positive, whatever the coefficients and links")
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const auto p = test::random_blocks(seed, 1e3);
        physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30, .shifted = true, .singular = false});
        solver.set_up(serial, p.coefficients(true));
        const auto cycle = [&](const std::vector<double>& in) {
            std::vector<double> out(solver.layout().size());
            solver.precondition(serial, in, out);
            return test::rows(p, solver.layout(), out);
        };
        const auto x = test::random_right(solver.layout(), seed), y = test::random_right(solver.layout(), seed + 100);
        const Eigen::VectorXd mx = cycle(x), my = cycle(y), rx = test::rows(p, solver.layout(), x), ry = test::rows(p, solver.layout(), y);
        // 32-bit round-off of a few hundred additions.
        CHECK(std::abs(ry.dot(mx) - rx.dot(my)) < 1e-4 * std::sqrt(rx.dot(mx) * ry.dot(my)));
        CHECK(rx.dot(mx) > 0.0);
    }
}

TEST_CASE("threads do not change a bit of the solution")
{
    const auto p = test::random_blocks(3, 10.0);
    std::vector<std::vector<double>> solutions;
    const auto two = core::make_openmp_team(2);
    for (const core::Team* team : {static_cast<const core::Team*>(&serial), static_cast<const core::Team*>(two.get())}) {
        physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30});
        solver.set_up(*team, p.coefficients());
        auto right = test::random_right(solver.layout(), 5);
        solutions.emplace_back(solver.layout().size(), 0.0);
        (void)solver.solve(*team, {.most_iterations = 500, .singular = true}, right, solutions.back());
    }
    CHECK(solutions[0] == solutions[1]);
}

TEST_CASE("a closed domain with a net source is refused, and the defect of round-off is reported")
{
    const auto p = test::random_blocks(2, 10.0);
    physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30});
    solver.set_up(serial, p.coefficients());
    auto right = test::random_right(solver.layout(), 5);
    std::vector<double> x(solver.layout().size(), 0.0);
    const auto report = solver.solve(serial, {.relative = 1e-14, .most_iterations = 500, .singular = true}, right, x);
    CHECK(report.defect < 1e-14);
    right[std::size_t(solver.layout().origin(0))] += 0.1;
    CHECK_THROWS_AS((void)solver.solve(serial, {.singular = true}, right, x), core::NumericsError);
    right[std::size_t(solver.layout().origin(0))] = std::nan("");
    CHECK_THROWS_AS((void)solver.solve(serial, {.singular = true}, right, x), core::NumericsError);
}

TEST_CASE("BiCGSTAB and conjugate gradients find the same solution")
{
    const auto p = test::random_blocks(4, 1e2);
    physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30});
    solver.set_up(serial, p.coefficients());
    auto right = test::random_right(solver.layout(), 5);
    std::vector<double> x(solver.layout().size(), 0.0), y = x;
    (void)solver.solve(serial, {.relative = 1e-11, .most_iterations = 500, .singular = true}, right, x);
    physics::KrylovReport report;
    const physics::KrylovOptions options{.relative = 1e-11, .most_iterations = 500, .singular = true};
    physics::drive(
        physics::bicgstab(serial, solver.workspace(), options, right, y, report),
        [&](auto in, auto out) { solver.apply(serial, in, out); }, [&](auto in, auto out) { solver.precondition(serial, in, out); });
    // Condition number some 1e4, residuals 1e-11.
    CHECK(difference_up_to_a_constant(test::rows(p, solver.layout(), y), test::rows(p, solver.layout(), x)) < 1e-6);
}

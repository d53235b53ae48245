// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "tests/support/conduction_boxes.hpp"
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
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const auto p = test::random_blocks(seed, 1e3);
        const auto coarsening = seed <= 5 ? physics::Coarsening::grid : physics::Coarsening::coefficients;
        physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 30, .coarsening = coarsening, .shifted = true, .singular = false});
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
        physics::bicgstab(serial, solver.workspace(), options, right, y, report), [&](auto in, auto out) { solver.apply(serial, in, out); },
        [&](auto in, auto out) { solver.precondition(serial, in, out); });
    // Condition number some 1e4, residuals 1e-11.
    CHECK(difference_up_to_a_constant(test::rows(p, solver.layout(), y), test::rows(p, solver.layout(), x)) < 1e-6);
}

TEST_CASE("walls that hold the unknown give the solution of a dense factorisation, quickly")
{
    for (const bool implicit_time : {false, true}) {
        const auto edge = test::uniform(11, 1.0);
        auto p = test::box_problem({{edge, edge, edge}, {2, 1, 1}}, [](double, double, double) { return 1.0; });
        for (int b = 0; b < 2; ++b)
            core::for_each_cell(p.topology.cells[std::size_t(b)], [&](int i, int j, int k) {
                const auto n = p.topology.cells[std::size_t(b)];
                const auto wall = [&](bool here, core::Side side) {
                    if (!here) return;
                    p.topology.links.push_back({{b, physics::cell_index(n, i, j, k), side}, {physics::wall_block, 0, side}});
                    p.link.push_back(2.0 / 11.0); // half a cell away
                };
                wall(j == 0, core::Side::j_low);
                wall(j == n.nj - 1, core::Side::j_high);
                wall(k == 0, core::Side::k_low);
                p.shift.on(b)(i, j, k) = 1e-3;
            });
        physics::SevenPointSolver solver(p.topology, {.coarsest_cells = 60, .shifted = implicit_time, .singular = false});
        solver.set_up(serial, p.coefficients(implicit_time));
        auto right = test::random_right(solver.layout(), 3);
        const Eigen::VectorXd expected = p.dense(implicit_time).ldlt().solve(test::rows(p, solver.layout(), right));
        std::vector<double> x(solver.layout().size(), 0.0);
        const auto report = solver.solve(serial, {.relative = 1e-10}, right, x);
        // Condition number some 1e2, residual 1e-10.
        CHECK((test::rows(p, solver.layout(), x) - expected).norm() < 1e-8 * expected.norm());
        CHECK(report.iterations <= 14);
    }
}

TEST_CASE("a right-hand side of zero needs no iteration, tiny and huge ones as many as others")
{
    const auto edge = test::uniform(16, 1.0);
    const auto p = test::box_problem({{edge, edge, edge}});
    physics::SevenPointSolver solver(p.topology, {});
    solver.set_up(serial, p.coefficients());
    std::vector<int> counts;
    for (const double size : {0.0, 1e-60, 1.0, 1e60}) {
        auto right = test::random_right(solver.layout(), 3);
        for (double& b : right) b *= size;
        std::vector<double> x(solver.layout().size(), 0.0);
        counts.push_back(solver.solve(serial, {.singular = true}, right, x).iterations);
    }
    CHECK(counts[0] == 0);
    CHECK(counts[1] == counts[2]);
    CHECK(counts[3] == counts[2]);
}

TEST_CASE("a closed domain solved to round-off again and again does not drift")
{
    const auto edge = test::uniform(12, 1.0);
    const auto p = test::box_problem({{edge, edge, edge}, {2, 1, 1}, {true, false, false}});
    physics::SevenPointSolver solver(p.topology, {});
    solver.set_up(serial, p.coefficients());
    std::vector<double> x(solver.layout().size(), 0.0);
    Eigen::VectorXd first;
    for (int time = 0; time < 20; ++time) {
        auto right = test::random_right(solver.layout(), 3);
        (void)solver.solve(serial, {.relative = 1e-14, .singular = true}, right, x);
        const Eigen::VectorXd found = test::rows(p, solver.layout(), x);
        if (time == 0) first = found;
        const double largest = first.lpNorm<Eigen::Infinity>();
        REQUIRE(found.allFinite());
        CHECK(std::abs(found.mean()) < 1e-14 * largest);                    // round-off of the sum of 1728 numbers
        CHECK((found - first).lpNorm<Eigen::Infinity>() < 1e-10 * largest); // round-off times the condition number
    }
}

TEST_CASE("flow across layers that differ by 1e5 is even, and pressure falls as their resistances say")
{
    constexpr int n = 12;
    const auto edge = test::uniform(n, n);
    for (const int period : {1, 3, 5}) {
        const auto p =
            test::box_problem({{edge, edge, edge}}, [=](double, double y, double) { return int(y) / period % 2 == 0 ? 1e-5 : 1.0; });
        physics::SevenPointSolver solver(p.topology, {});
        solver.set_up(serial, p.coefficients());
        const auto& layout = solver.layout();
        const auto flat = [&](int i, int j, int k) { return std::size_t(layout.origin(0) + physics::cell_index({n, n, n}, i, j, k)); };
        std::vector<double> right(layout.size(), 0.0), x = right;
        for (int k = 0; k < n; ++k)
            for (int i = 0; i < n; ++i) {
                right[flat(i, 0, k)] = 1.0;
                right[flat(i, n - 1, k)] = -1.0;
            }
        (void)solver.solve(serial, {.relative = 1e-12, .singular = true}, right, x);
        double largest_off = 0.0;
        core::for_each_cell({n, n - 1, n}, [&](int i, int j, int k) {
            const double through = p.face.on(0).j(i, j + 1, k) * (x[flat(i, j, k)] - x[flat(i, j + 1, k)]);
            largest_off = std::max(largest_off, std::abs(through - 1.0));
        });
        CHECK(largest_off < 1e-6); // a spike would be twice the flow; residuals of 1e-12, 24 cells in the way, round-off of 1e-16 * 1e6 / 1
    }
}

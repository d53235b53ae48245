// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Pressure where coefficients of neighbouring cells differ by 1e5: iterations and memory on a grid of ordinary size.
// ctest: timeout=300 long
#include "tests/support/conduction_jumps.hpp"
#include "tests/support/solver_bytes.hpp"
#include <doctest/doctest.h>

TEST_CASE("262k cells with jumps of 1e5 take at most 20 iterations and 150 bytes a cell, whatever the pattern and the blocks")
{
    const core::SerialTeam serial;
    for (const auto& pattern : test::jump_cases)
        for (const auto blocks : {std::array{1, 1, 1}, std::array{2, 2, 4}}) {
            const auto p = test::jump_problem(pattern, 64, blocks, 1e-5);
            physics::SevenPointSolver solver(p.topology, {});
            solver.set_up(serial, p.coefficients());
            auto right = test::random_right(solver.layout(), 7);
            std::vector<double> x(solver.layout().size(), 0.0);
            const int iterations = solver.solve(serial, {.relative = 1e-8, .most_iterations = 100, .singular = true}, right, x).iterations;
            const double bytes = test::matrix_bytes(solver, double(physics::cell_count(p.topology)));
            MESSAGE(std::string(pattern.name) << ", " << solver.layout().blocks() << " blocks: " << iterations << " iterations, " << bytes
                                              << " B/cell");
            CHECK(iterations <= 20);
            CHECK(bytes <= 150.0);
        }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Iterations of the multigrid-preconditioned solver: independent of resolution, aspect ratio and cutting into blocks.
#include "tests/support/conduction_jumps.hpp"
#include "tests/support/conduction_pipe.hpp"
#include <doctest/doctest.h>

namespace {

const core::SerialTeam serial;

/// Iterations to a relative residual of 1e-8, and the name of the case with the count as a message.
int iterations(const std::string& name, const test::ConductionProblem& p, physics::MultigridOptions options = {})
{
    physics::SevenPointSolver solver(p.topology, options);
    solver.set_up(serial, p.coefficients());
    auto right = test::random_right(solver.layout(), 7);
    const auto& layout = solver.layout();
    for (int b = 0; b < layout.blocks(); ++b) // a smooth part, without a net source: a dipole of every block's ends
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size() / 2; ++c) {
            right[std::size_t(layout.origin(b) + c)] += 1.0;
            right[std::size_t(layout.origin(b) + layout.cells(b).size() - 1 - c)] -= 1.0;
        }
    std::vector<double> x(solver.layout().size(), 0.0);
    const auto report = solver.solve(serial, {.relative = 1e-8, .most_iterations = 300, .singular = true}, right, x);
    MESSAGE(name << ": " << physics::cell_count(p.topology) << " cells, " << report.iterations << " iterations");
    return report.iterations;
}

test::BoxGrid cube(int n) { return {{test::uniform(n, 1.0), test::uniform(n, 1.0), test::uniform(n, 1.0)}}; }

/// Channel between walls at y = 0 and 1; cells at the walls are `aspect` times as long as high.
test::BoxGrid channel(int n, double aspect)
{
    return {{test::uniform(n, 3.0), test::between_walls(n * 3 / 2, 3.0 / n / aspect), test::uniform(n, 1.5)}};
}

} // namespace

TEST_CASE("a cube takes at most 12 iterations at any resolution")
{
    for (int n : {16, 32, 64}) CHECK(iterations("cube", test::box_problem(cube(n))) <= 12);
    CHECK(iterations("cube of odd size", test::box_problem(cube(37))) <= 14);
}

TEST_CASE("a channel with aspect ratio 1000 takes at most 20 iterations")
{
    for (int n : {16, 32, 64}) CHECK(iterations("channel", test::box_problem(channel(n, 1000.0))) <= 20);
}

TEST_CASE("a channel takes no more iterations where the lines between its walls are cut")
{
    auto grid = channel(32, 1000.0);
    for (const int cut : {1, 2, 4, 8}) {
        grid.blocks = {1, cut, 1};
        CHECK(iterations("channel cut", test::box_problem(grid)) <= 20);
    }
    const test::BoxGrid flat{{test::uniform(32, 2000.0), test::uniform(16, 1.0), test::uniform(32, 2000.0)}};
    for (const bool closed : {false, true})
        for (const int cut : {1, 2, 4, 8, 16}) {
            auto g = flat;
            g.blocks = {1, cut, 2};
            g.periodic = {false, closed, true};
            CHECK(iterations(closed ? "flat cells, closed, cut" : "flat cells, cut", test::box_problem(g)) <= 20);
        }
}

TEST_CASE("blocks and periodic sides cost few iterations")
{
    auto grid = cube(48);
    grid.blocks = {3, 2, 4};
    CHECK(iterations("24 blocks", test::box_problem(grid)) <= 14);
    grid.periodic = {true, false, true};
    CHECK(iterations("24 blocks, periodic", test::box_problem(grid)) <= 14);
    grid.blocks = {1, 1, 1};
    CHECK(iterations("one block, periodic with itself", test::box_problem(grid)) <= 14);
}

TEST_CASE("jumps of 1e3 between neighbouring cells are no obstacle")
{
    const auto spheres = [](double x, double y, double z) { return test::bed_and_spheres(x, y, z) == 0.36 ? 1e-3 : 1.0; };
    CHECK(iterations("spheres 1e-3", test::box_problem(cube(32), spheres)) <= 20);
    const auto bed = [](double, double y, double) { return y < 0.37 ? 1e-3 : 1.0; };
    CHECK(iterations("bed 1e-3", test::box_problem(cube(32), bed)) <= 20);
    CHECK(iterations("bed 1e-3, odd size", test::box_problem(cube(37), bed)) <= 20);
    auto grid = cube(48);
    grid.blocks = {3, 2, 4};
    CHECK(iterations("spheres 1e-3 in 24 blocks", test::box_problem(grid, spheres)) <= 20);
    const auto islands = [](double x, double y, double z) { return test::bed_and_spheres(x, y, z) == 0.36 ? 1.0 : 1e-3; };
    CHECK(iterations("islands 1e3", test::box_problem(cube(32), islands)) <= 20);
}

TEST_CASE("a pipe on a butterfly grid takes at most 20 iterations at any resolution")
{
    for (int size : {1, 2}) CHECK(iterations("pipe", test::pipe_problem(size)) <= 20);
    CHECK(iterations("pipe, thin cells at the wall", test::pipe_problem(1, 20.0)) <= 20);
}

TEST_CASE("jumps of 1e5 between neighbouring cells take few iterations, whatever their pattern and the blocks")
{
    for (const auto& pattern : test::jump_cases)
        for (const auto blocks : {std::array{1, 1, 1}, std::array{2, 1, 1}, std::array{2, 2, 4}})
            CHECK(iterations(std::string(pattern.name) + ", " + std::to_string(blocks[0] * blocks[1] * blocks[2]) + " blocks",
                             test::jump_problem(pattern, 24, blocks, 1e-5)) <= 20);
}

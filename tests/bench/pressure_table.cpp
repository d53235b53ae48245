// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The pressure solver on the grids that it must be good at: pressure_table [THREADS] prints iterations to 1e-8, V-cycles, work in
// products of the equation's own operator, and bytes per cell. Needs 2 GB and a minute.
#include "core/comm/communicator.hpp"
#include "tests/support/conduction_jumps.hpp"
#include "tests/support/conduction_pipe.hpp"
#include "tests/support/pressure_on_grid.hpp"
#include "tests/support/processor_time.hpp"
#include "tests/support/solver_bytes.hpp"
#include "tests/support/stretched_channel.hpp"
#include <cstdio>

namespace {

using test::seconds;

void print_head(const char* what)
{
    std::printf("\n%s\n%-34s %9s %6s %8s %9s %9s %12s %14s\n", what, "grid", "cells", "iter.", "V-cycles", "products", "ns / cell",
                "matrix B/cell", "vectors B/cell");
}

struct Row {
    std::string name;
    double cells, product, solve; ///< cells; [s]; [s]
    int iterations, cycles;
    double matrix, vectors; ///< [B/cell]
};

void print(const Row& r)
{
    std::printf("%-34s %9.0f %6d %8d %9.0f %9.0f %12.0f %14.0f\n", r.name.c_str(), r.cells, r.iterations, r.cycles, r.solve / r.product,
                1e9 * r.solve / r.cells, r.matrix, r.vectors);
    std::fflush(stdout);
}

/// Seven points, by conjugate gradients.
void run_straight(const core::Team& team, const std::string& name, const test::ConductionProblem& p,
                  const physics::MultigridOptions& options = {})
{
    physics::SevenPointSolver solver(p.topology, options);
    solver.set_up(team, p.coefficients());
    const auto right = test::random_right(solver.layout(), 7);
    std::vector<double> x(solver.layout().size(), 0.0), y = x;
    const double product = seconds(5, [&] { solver.apply(team, right, y); });
    physics::KrylovReport report;
    const double solve = seconds(2, [&] {
        auto b = right;
        std::fill(x.begin(), x.end(), 0.0);
        report = solver.solve(team, {.singular = true}, b, x);
    });
    const double cells = double(physics::cell_count(p.topology));
    const double vectors = 8.0 * double(solver.layout().size()) * double(solver.workspace().vectors.size() + 2) / cells;
    print({name, cells, product, solve, report.iterations, report.iterations, test::matrix_bytes(solver, cells), vectors});
}

/// The full operator with cross terms, by BiCGSTAB.
void run_bent(const core::Team& team, const std::string& name, core::MultiBlock grid, double wave_length)
{
    test::PressureOnGrid problem(std::move(grid), wave_length);
    auto& system = problem.system();
    physics::KrylovReport report;
    const double solve = seconds(2, [&] { report = problem.solve(team); });
    std::vector<double> x(system.layout().size(), 0.0), y = x;
    const double product =
        seconds(5, [&] { tasks::run(problem.ranks(), team, [&](tasks::Lane& lane) { return system.apply(lane, x, y); }); });
    const double cells = double(problem.mesh().total_cells());
    const double vectors = 8.0 * double(x.size()) * double(system.solver().workspace().vectors.size() + 2) / cells;
    print({name, cells, product, solve, report.iterations, 2 * report.iterations, test::matrix_bytes(system.solver(), cells), vectors});
}

core::MultiBlock slanted(int n, double degrees)
{
    const double slope = std::tan(degrees * std::numbers::pi / 180);
    return core::make_box({{0, 0, 0}, {1, 1, 1}, {n, n, n}, {1, 1, 1}, {}},
                          [=](const core::Vec3& x) { return core::Vec3(x.x() + slope * x.y(), x.y(), x.z()); });
}

void straight_grids(const core::Team& team)
{
    print_head("seven points, conjugate gradients, one V-cycle and one product each");
    for (const int n : {27, 54, 128}) {
        const auto edge = test::uniform(n, 1.0);
        run_straight(team, "box", test::box_problem({{edge, edge, edge}}));
    }
    for (const int size : {1, 2, 4}) run_straight(team, "butterfly pipe", test::pipe_problem(size));
    for (const int cut : {1, 2, 4, 8}) {
        test::BoxGrid grid{{test::uniform(64, 3.0), test::between_walls(96, 3e-3 / 64), test::uniform(64, 1.5)}, {1, cut, 1}};
        run_straight(team, "channel 1000 at walls, cut in " + std::to_string(cut), test::box_problem(grid));
        grid.vertices = {test::uniform(64, 64e3 / 96), test::uniform(96, 1.0), test::uniform(64, 64e3 / 96)};
        run_straight(team, "flat cells 1000, cut in " + std::to_string(cut), test::box_problem(grid));
    }
}

void bent_grids(const core::Team& team)
{
    print_head("full operator, BiCGSTAB, two V-cycles and two products each");
    for (const int cut : {1, 2, 4, 8}) {
        run_bent(team, "bent, 1000 at walls, cut in " + std::to_string(cut),
                 test::stretched_channel({{32, 48, 16}, {1, cut, 1}, 1000.0, true}), 1.0);
        run_bent(team, "bent, 1000 everywhere, cut in " + std::to_string(cut), test::stretched_channel({{32, 48, 16}, {1, cut, 1}, 1000.0}),
                 1000.0);
    }
    for (const double degrees : {30.0, 60.0, 75.0})
        run_bent(team, "slanted by " + std::to_string(int(degrees)) + " degrees", slanted(64, degrees), 0.3);
}

void jumps(const core::Team& team)
{
    print_head("seven points, neighbouring cells differ by 1e5");
    for (const auto& c : test::jump_cases)
        for (const auto blocks : {std::array{1, 1, 1}, std::array{2, 2, 4}})
            run_straight(team, std::string(c.name) + ", blocks: " + std::to_string(blocks[0] * blocks[1] * blocks[2]),
                         test::jump_problem(c, 64, blocks, 1e-5));
}

} // namespace

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
    const auto team = core::make_openmp_team(argc > 1 ? std::stoi(argv[1]) : 1);
    straight_grids(*team);
    jumps(*team);
    bent_grids(*team);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Speed of the linear solvers: pressure_bench [cube|channel|pipe] [SIZE] [THREADS] [automatic|point|line]
// Sizes: cells along an edge of the cube or channel (64); multiples of 21,000 cells in the pipe: 1, 2 (x 8), 4 (x 64).
#include "core/comm/communicator.hpp"
#include "tests/support/conduction_pipe.hpp"
#include "tests/support/processor_time.hpp"
#include <algorithm>
#include <cstdio>
#include <string>

namespace {

using test::seconds;

test::ConductionProblem problem(const std::string& kind, int size)
{
    if (kind == "pipe") return test::pipe_problem(size);
    const auto edge = test::uniform(size, 1.0);
    if (kind == "cube") return test::box_problem({{edge, edge, edge}});
    return test::box_problem({{test::uniform(size, 3.0), test::between_walls(size * 3 / 2, 3e-3 / size), test::uniform(size, 1.5)}});
}

const char* step_name(physics::MultigridStep::Kind kind)
{
    using K = physics::MultigridStep::Kind;
    switch (kind) {
    case K::smooth_from_zero: return "smooth from zero";
    case K::smooth_first: return "smooth first";
    case K::smooth_second: return "smooth second";
    case K::residual: return "residual";
    case K::gather_children: return "gather children";
    case K::share_inside: return "share inside";
    case K::share_over_links: return "share over links";
    case K::coarsest: return "coarsest";
    case K::prolong_up: return "prolong";
    default: return "set-up";
    }
}

} // namespace

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
    const std::string kind = argc > 1 ? argv[1] : "cube", smoother = argc > 4 ? argv[4] : "automatic";
    const int size = argc > 2 ? std::stoi(argv[2]) : kind == "pipe" ? 1 : 64, threads = argc > 3 ? std::stoi(argv[3]) : 1;
    const auto team = core::make_openmp_team(threads);
    const auto p = problem(kind, size);
    physics::MultigridOptions options;
    options.smoother = smoother == "point"  ? physics::Smoother::point
                       : smoother == "line" ? physics::Smoother::line
                                            : physics::Smoother::automatic;
    physics::SevenPointSolver solver(p.topology, options);
    const double set_up = seconds(3, [&] { solver.set_up(*team, p.coefficients()); });
    const double cells = double(physics::cell_count(p.topology));
    const auto right = test::random_right(solver.layout(), 7);
    std::vector<double> x(solver.layout().size(), 0.0), y = x;
    const double product = seconds(20, [&] { solver.apply(*team, right, y); });
    const double cycle = seconds(10, [&] { solver.precondition(*team, right, y); });
    physics::KrylovReport report;
    const double solve = seconds(3, [&] {
        auto b = right;
        std::fill(x.begin(), x.end(), 0.0);
        report = solver.solve(*team, {.singular = true}, b, x);
    });
    const double vectors = 8.0 * double(solver.layout().size()) * double(3 + solver.workspace().vectors.size() + 2) / cells;
    std::printf("%s %d: %.0f cells, %zu links, %d threads, %zu levels\n", kind.c_str(), size, cells, p.link.size(), threads,
                solver.multigrid().levels().size());
    std::printf("  product %.3f ms = %.2f ns/cell = %.1f GB/s at 40 B/cell\n", 1e3 * product, 1e9 * product / cells,
                40e-9 * cells / product);
    std::printf("  set-up %.2f ms = %.1f products; cycle %.3f ms = %.1f products\n", 1e3 * set_up, set_up / product, 1e3 * cycle,
                cycle / product);
    std::printf("  solve %.1f ms = %.0f products, %d iterations\n", 1e3 * solve, solve / product, report.iterations);
    std::printf("  memory: multigrid %.0f, operator and vectors %.0f B/cell\n", double(solver.multigrid().bytes()) / cells, vectors);
    for (int level = 0; level < 2; ++level)
        for (const auto& step : solver.multigrid().cycle_steps())
            if (step.level == level)
                std::printf("    level %d %-17s %.3f ms\n", level, step_name(step.kind),
                            1e3 * seconds(5, [&] { solver.multigrid().run(*team, step); }));
}

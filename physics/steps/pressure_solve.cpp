// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/pressure_solve.hpp"
#include "physics/steps/krylov_job.hpp"

namespace physics {
tasks::Job announce_right(tasks::Lane& lane, SevenPointSolver& solver, std::span<const double> right)
{
    double largest = 0.0;
    lane.attempt([&] { largest = largest_magnitude(solver.layout(), right); });
    co_await lane.max(std::span(&largest, 1));
    solver.expect_right(largest);
}

tasks::Job run_steps(tasks::Lane& lane, Multigrid& multigrid, std::span<const MultigridStep> steps)
{
    for (const auto& step : steps) {
        if (!step.sends()) {
            lane.attempt([&] { multigrid.run(lane.team(), step); });
            continue;
        }
        core::Pending pending;
        {
            const auto mpi = lane.messages();
            multigrid.start(step, lane.communicator(), pending);
        }
        co_await lane.arrive(pending);
        multigrid.complete(step, lane.communicator());
    }
}

tasks::Job set_up(tasks::Lane& lane, SevenPointSolver& solver, Coefficients coefficients)
{
    std::array<double, 2> range{};
    lane.attempt([&] {
        solver.copy(lane.team(), coefficients);
        range = coefficient_range(solver.mesh(), solver.matrix()).numbers();
    });
    co_await lane.max(range);
    lane.attempt([&] { solver.load(lane.team(), {range[0], range[1]}); });
    co_await run_steps(lane, solver.multigrid(), solver.multigrid().set_up_steps());
}

tasks::Job exchange_ghosts(tasks::Lane& lane, SevenPointSolver& solver, std::span<double> values)
{
    if (solver.mesh().exchanges.empty()) co_return;
    core::Pending pending;
    {
        const auto mpi = lane.messages();
        solver.messages().start_ghosts(solver.mesh(), values, lane.communicator(), pending);
    }
    co_await lane.arrive(pending);
}

tasks::Job apply(tasks::Lane& lane, SevenPointSolver& solver, std::span<double> in, std::span<double> out)
{
    co_await exchange_ghosts(lane, solver, in);
    lane.attempt([&] { solver.apply(lane.team(), in, out); });
}

tasks::Job precondition(tasks::Lane& lane, SevenPointSolver& solver, std::span<const double> in, std::span<double> out)
{
    auto& multigrid = solver.multigrid();
    multigrid.load_right(lane.team(), in, solver.right_scale());
    co_await run_steps(lane, multigrid, multigrid.cycle_steps());
    multigrid.store_solution(lane.team(), out);
}

namespace {

/// The 7-point operator with its V-cycle, as drive() wants them.
struct SevenPointSystem {
    SevenPointSolver& solver;
    tasks::Job apply(tasks::Lane& lane, std::span<double> in, std::span<double> out) const { return physics::apply(lane, solver, in, out); }
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out) const
    {
        return physics::precondition(lane, solver, in, out);
    }
};

} // namespace

tasks::Job solve(tasks::Lane& lane, SevenPointSolver& solver, const KrylovOptions& options, std::span<double> right, std::span<double> x,
                 KrylovReport& report)
{
    SevenPointSystem system{solver};
    co_await announce_right(lane, solver, right);
    co_await drive(lane, flexible_cg(lane.team(), solver.workspace(), options, right, x, report), system);
}

} // namespace physics

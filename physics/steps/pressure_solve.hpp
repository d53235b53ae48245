// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Linear solves on many ranks: the steps of the multigrid and the demands of the Krylov solvers as jobs that wait for
// messages without holding a thread.
#include "physics/fluid/seven_point_solver.hpp"
#include "tasks/lane.hpp"
#include <span>

namespace physics {

/// Runs the steps of a set-up or of a cycle.
tasks::Job run_steps(tasks::Lane& lane, Multigrid& multigrid, std::span<const MultigridStep> steps);

/// Copies the coefficients of this step and sets up the multigrid.
tasks::Job set_up(tasks::Lane& lane, SevenPointSolver& solver, Coefficients coefficients);

/// Brings the ghosts of a flat array of the finest level up to date.
tasks::Job exchange_ghosts(tasks::Lane& lane, SevenPointSolver& solver, std::span<double> values);

/// out = A in with the 7-point operator; updates the ghosts of `in`.
tasks::Job apply(tasks::Lane& lane, SevenPointSolver& solver, std::span<double> in, std::span<double> out);

/// out = one V-cycle for the right-hand side `in`.
tasks::Job precondition(tasks::Lane& lane, SevenPointSolver& solver, std::span<const double> in, std::span<double> out);

/// Tells the solver the largest magnitude of right-hand sides to come, over all ranks.
tasks::Job announce_right(tasks::Lane& lane, SevenPointSolver& solver, std::span<const double> right);

/// The 7-point system by flexible conjugate gradients.
/// @param right  Its mean is removed if the system is singular.
/// @param x      First guess in, solution out.
tasks::Job solve(tasks::Lane& lane, SevenPointSolver& solver, const KrylovOptions& options, std::span<double> right, std::span<double> x,
                 KrylovReport& report);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/seven_point_solver.hpp"

#include <algorithm>
#include <cmath>

namespace physics {

SevenPointSolver::SevenPointSolver(const BlockTopology& topology, const MultigridOptions& options, const core::Communicator& communicator)
    : communicator_(communicator),
      multigrid_(topology, options, communicator),
      matrix_(make_seven_point<double>(multigrid_.mesh(), options.shifted)),
      workspace_(multigrid_.mesh().layout, int(topology.cells.size()), cell_count(topology))
{
}

SevenPointSolver::SevenPointSolver(const SevenPointSolver& other, WithShift shift)
    : communicator_(other.communicator_),
      multigrid_(other.multigrid_, shift),
      matrix_(make_seven_point<double>(multigrid_.mesh(), true)),
      workspace_(multigrid_.mesh().layout, other.workspace_.sums.all_blocks(), other.workspace_.all_cells)
{
}

void SevenPointSolver::copy(const core::Team& team, const Coefficients& coefficients)
{
    layout().for_pieces(team, [&](int n) { copy_coefficients(mesh(), coefficients, n, matrix_); });
    copy_links(mesh(), coefficients, multigrid_.link_source(), matrix_);
}

void SevenPointSolver::set_up(const core::Team& team, const Coefficients& coefficients)
{
    copy(team, coefficients);
    auto range = coefficient_range(mesh(), matrix_).numbers();
    communicator_.max(range);
    load(team, {range[0], range[1]});
    run_steps(team, communicator_, multigrid_, multigrid_.set_up_steps());
}

void SevenPointSolver::apply(const core::Team& team, std::span<const double> in, std::span<double> out) const
{
    layout().for_pieces(team, [&](int n) { net_outflow(mesh(), matrix_, n, in.data(), out.data()); });
}

void SevenPointSolver::precondition(const core::Team& team, std::span<const double> in, std::span<double> out)
{
    multigrid_.load_right(team, in, right_scale_);
    run_steps(team, communicator_, multigrid_, multigrid_.cycle_steps());
    multigrid_.store_solution(team, out);
}

KrylovReport SevenPointSolver::solve(const core::Team& team, const KrylovOptions& options, std::span<double> right, std::span<double> x)
{
    expect_right(largest_magnitude(layout(), right));
    KrylovReport report;
    drive(
        flexible_cg(team, workspace_, options, right, x, report), [&](auto in, auto out) { apply(team, in, out); },
        [&](auto in, auto out) { precondition(team, in, out); });
    return report;
}

double largest_magnitude(const BlockLayout& layout, std::span<const double> values)
{
    double largest = 0.0;
    for (const auto& p : layout.pieces())
        for (auto c = std::size_t(p.begin); c < std::size_t(p.end); ++c) largest = std::max(largest, std::abs(values[c]));
    return largest;
}

} // namespace physics

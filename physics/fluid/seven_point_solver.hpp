// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The 7-point operator with its multigrid and the memory of its Krylov solver: everything to solve one equation.
#include "physics/fluid/krylov.hpp"
#include "physics/fluid/multigrid.hpp"

namespace physics {

class SevenPointSolver {
public:
    /// Collective over `communicator`.
    SevenPointSolver(const BlockTopology& topology, const MultigridOptions& options,
                     const core::Communicator& communicator = core::Communicator::self());

    /// The same grids for an operator with a shift, coefficients to be loaded. No message.
    SevenPointSolver(const SevenPointSolver& other, WithShift shift);

    [[nodiscard]] const LevelMesh& mesh() const { return multigrid_.mesh(); }
    [[nodiscard]] const BlockLayout& layout() const { return multigrid_.mesh().layout; }
    [[nodiscard]] const Multigrid& multigrid() const { return multigrid_; }
    [[nodiscard]] const KrylovWorkspace& workspace() const { return workspace_; }
    [[nodiscard]] const SevenPoint<double>& matrix() const { return matrix_; }
    [[nodiscard]] Multigrid& multigrid() { return multigrid_; }
    [[nodiscard]] KrylovWorkspace& workspace() { return workspace_; }
    [[nodiscard]] LevelMessages& messages() { return messages_; }

    /// Copies the coefficients; load() and the set-up of the multigrid come next.
    void copy(const core::Team& team, const Coefficients& coefficients);
    /// Hands the coefficients to the multigrid.
    /// @param range  Of all ranks.
    void load(const core::Team& team, const CoefficientRange& range) { multigrid_.load(team, matrix_, range); }
    /// Sizes of right-hand sides, so that they keep their digits in 32 bits.
    /// @param largest  Magnitude of all ranks.
    void expect_right(double largest) { right_scale_ = power_of_two_scale(largest); }
    [[nodiscard]] double right_scale() const { return right_scale_; }
    /// Copies the coefficients and sets up the multigrid, waiting for messages on the spot. Collective.
    void set_up(const core::Team& team, const Coefficients& coefficients);
    /// out = A in; ghosts of `in` must be up to date.
    void apply(const core::Team& team, std::span<const double> in, std::span<double> out) const;
    /// out = one V-cycle for the right-hand side `in`, on one rank.
    void precondition(const core::Team& team, std::span<const double> in, std::span<double> out);
    /// A x = right on one rank, by flexible conjugate gradients.
    /// @param x  First guess in, solution out.
    KrylovReport solve(const core::Team& team, const KrylovOptions& options, std::span<double> right, std::span<double> x);

private:
    core::Communicator communicator_;
    Multigrid multigrid_;
    SevenPoint<double> matrix_;
    KrylovWorkspace workspace_;
    LevelMessages messages_;
    double right_scale_ = 1.0;
};

/// Largest magnitude in the cells of this rank.
[[nodiscard]] double largest_magnitude(const BlockLayout& layout, std::span<const double> values);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The 7-point operator with its multigrid and the memory of its Krylov solver: everything to solve one equation.
#include "physics/fluid/krylov.hpp"
#include "physics/fluid/multigrid.hpp"

namespace physics {

class SevenPointSolver {
public:
    SevenPointSolver(const BlockTopology& topology, const MultigridOptions& options);

    [[nodiscard]] const LevelMesh& mesh() const { return multigrid_.mesh(); }
    [[nodiscard]] const BlockLayout& layout() const { return multigrid_.mesh().layout; }
    [[nodiscard]] const SevenPoint<double>& matrix() const { return matrix_; }
    [[nodiscard]] Multigrid& multigrid() { return multigrid_; }
    [[nodiscard]] KrylovWorkspace& workspace() { return workspace_; }

    /// Copies the coefficients; the multigrid must be loaded and set up next.
    void copy(const core::Team& team, const Coefficients& coefficients);
    /// Copies the coefficients and sets up the multigrid, on one rank.
    void set_up(const core::Team& team, const Coefficients& coefficients);
    /// out = A in; ghosts of `in` must be up to date.
    void apply(const core::Team& team, std::span<const double> in, std::span<double> out) const;
    /// out = one V-cycle for the right-hand side `in`, on one rank.
    void precondition(const core::Team& team, std::span<const double> in, std::span<double> out);
    /// A x = right on one rank, by flexible conjugate gradients.
    /// @param x  First guess in, solution out.
    KrylovReport solve(const core::Team& team, const KrylovOptions& options, std::span<double> right, std::span<double> x);

private:
    Multigrid multigrid_;
    SevenPoint<double> matrix_;
    KrylovWorkspace workspace_;
    double right_scale_ = 1.0;
};

} // namespace physics

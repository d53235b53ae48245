// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Direct solution on the coarsest level: sparse L D L^T.
#include "physics/fluid/multigrid_level.hpp"
#include <memory>

namespace physics {

class CoarsestSolver {
public:
    explicit CoarsestSolver(const LevelMesh& mesh);
    ~CoarsestSolver();
    CoarsestSolver(CoarsestSolver&&) noexcept;
    CoarsestSolver& operator=(CoarsestSolver&&) noexcept;

    /// Factorises the matrix of the level. A singular matrix gets the first diagonal entry doubled: the solution of a
    /// compatible system then differs by a constant, which the null space allows.
    /// @throws NumericsError if the factorisation fails.
    void factorise(const MultigridLevel& level, bool singular);
    /// level.solution from level.right.
    void solve(MultigridLevel& level);

private:
    struct Implementation; // keeps Eigen's sparse headers out of what includes this file
    std::unique_ptr<Implementation> implementation_;
};

} // namespace physics

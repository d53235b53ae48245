// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Direct solution on the coarsest level of structured blocks.
#include "physics/fluid/multigrid_level.hpp"
#include "physics/fluid/sparse_factors.hpp"

namespace physics {

class CoarsestSolver {
public:
    explicit CoarsestSolver(const LevelMesh& mesh);

    /// Factorises the matrix of the level.
    /// @throws NumericsError if the factorisation fails.
    void factorise(const MultigridLevel& level, bool singular);
    /// level.solution from level.right.
    void solve(MultigridLevel& level);

private:
    /// Entries of the lower triangle, always in the same order; values may be zero.
    void fill_entries(const LevelMesh& mesh, const SevenPoint<float>* a);

    SparseFactors factors_;
    std::vector<int> place_; ///< flat place of each row
    std::vector<int> row_;   ///< row of each flat place
    std::vector<MatrixEntry> entries_;
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A sequence of similar sparse systems, solved roughly: the incomplete factors of one serve the next few.
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <vector>

namespace core {

class SparseSolver {
public:
    /// Solves for three right-hand sides to a hundredth of their size, by BiCGSTAB.
    [[nodiscard]] Eigen::MatrixX3d solved(const std::vector<Eigen::Triplet<double>>& entries, const Eigen::MatrixX3d& right);

private:
    [[nodiscard]] Eigen::VectorXd solved(const Eigen::VectorXd& right) const;

    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;
    Eigen::IncompleteLUT<double> factors_;
    int age_ = 0; ///< of the factors
};

} // namespace core

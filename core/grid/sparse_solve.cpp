// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/sparse_solve.hpp"

#include <cmath>

namespace core {
namespace {

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    double sum = 0;
    for (Eigen::Index n = 0; n < a.size(); ++n) sum += a[n] * b[n];
    return sum;
}

double norm(const Eigen::VectorXd& a) { return std::sqrt(dot(a, a)); }

} // namespace

Eigen::MatrixX3d SparseSolver::solved(const std::vector<Eigen::Triplet<double>>& entries, const Eigen::MatrixX3d& right)
{
    constexpr int most_reuses = 8;
    matrix_.resize(right.rows(), right.rows());
    matrix_.setFromTriplets(entries.begin(), entries.end());
    if (age_++ % most_reuses == 0) {
        factors_.setDroptol(1e-3);
        factors_.setFillfactor(4);
        factors_.compute(matrix_);
    }
    Eigen::MatrixX3d all(right.rows(), 3);
    for (int n = 0; n < 3; ++n) all.col(n) = solved(Eigen::VectorXd(right.col(n)));
    return all;
}

/// @source  van der Vorst (1992), the method; preconditioned from the right.
Eigen::VectorXd SparseSolver::solved(const Eigen::VectorXd& right) const
{
    constexpr double tolerance = 1e-2;
    constexpr int most_iterations = 60;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size()), residual = right, direction = right;
    const double enough = tolerance * norm(right);
    double rho = dot(residual, right);
    for (int n = 0; n < most_iterations && norm(residual) > enough && rho != 0; ++n) {
        const Eigen::VectorXd along = factors_.solve(direction), image = matrix_ * along;
        const double alpha = rho / dot(image, right);
        const Eigen::VectorXd half = residual - alpha * image, correction = factors_.solve(half), corrected = matrix_ * correction;
        const double square = dot(corrected, corrected), omega = square > 0 ? dot(corrected, half) / square : 0;
        x += alpha * along + omega * correction;
        residual = half - omega * corrected;
        const double next = dot(residual, right), beta = next / rho * alpha / (omega != 0 ? omega : 1);
        direction = residual + beta * (direction - omega * image);
        rho = next;
    }
    return x;
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/sparse_factors.hpp"

#include "core/base/error.hpp"
#include <Eigen/SparseCholesky>

namespace physics {

struct SparseFactors::Implementation {
    Eigen::SparseMatrix<double> matrix;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
    Eigen::VectorXd values, work;
};

SparseFactors::SparseFactors() : implementation_(std::make_unique<Implementation>()) {}
SparseFactors::~SparseFactors() = default;
SparseFactors::SparseFactors(SparseFactors&&) noexcept = default;
SparseFactors& SparseFactors::operator=(SparseFactors&&) noexcept = default;

void SparseFactors::analyse(int rows, const std::vector<MatrixEntry>& entries)
{
    auto& s = *implementation_;
    s.matrix.resize(rows, rows);
    s.values.resize(rows);
    s.work.resize(rows);
    s.matrix.setFromTriplets(entries.begin(), entries.end());
    s.factors.analyzePattern(s.matrix);
}

void SparseFactors::factorise(const std::vector<MatrixEntry>& entries, bool singular)
{
    auto& s = *implementation_;
    if (s.matrix.rows() == 0) return;
    s.matrix.setFromTriplets(entries.begin(), entries.end());
    if (singular) s.matrix.coeffRef(0, 0) += s.matrix.coeff(0, 0);
    s.factors.factorize(s.matrix);
    core::require<core::NumericsError>(s.factors.info() == Eigen::Success && s.factors.vectorD().allFinite(),
                                       "multigrid: the coarsest level has no factorisation; are there cells without any "
                                       "transmissibility, or coefficients that are not finite?");
}

std::span<double> SparseFactors::values() { return {implementation_->values.data(), std::size_t(implementation_->values.size())}; }

void SparseFactors::solve()
{
    auto& s = *implementation_;
    if (s.matrix.rows() == 0) return;
    s.work.noalias() = s.factors.permutationP() * s.values;
    s.factors.matrixL().solveInPlace(s.work);
    s.work.array() /= s.factors.vectorD().array();
    s.factors.matrixU().solveInPlace(s.work);
    s.values.noalias() = s.factors.permutationPinv() * s.work;
}

} // namespace physics

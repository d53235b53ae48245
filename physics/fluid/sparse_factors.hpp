// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sparse L D L^T of a symmetric matrix, for the coarsest levels.
#include <memory>
#include <span>
#include <vector>

namespace physics {

/// An addend of an entry of the lower triangle.
class MatrixEntry {
public:
    MatrixEntry(int row, int column, double value) : row_(row), column_(column), value_(value) {}
    [[nodiscard]] int row() const { return row_; }
    [[nodiscard]] int col() const { return column_; }
    [[nodiscard]] double value() const { return value_; }

private:
    int row_, column_;
    double value_;
};

class SparseFactors {
public:
    SparseFactors();
    ~SparseFactors();
    SparseFactors(SparseFactors&&) noexcept;
    SparseFactors& operator=(SparseFactors&&) noexcept;

    /// Finds an order of elimination for the pattern of the entries, whatever their values.
    void analyse(int rows, const std::vector<MatrixEntry>& entries);
    /// @param entries   Of the pattern analysed.
    /// @param singular  The first diagonal entry is doubled: the solution of a compatible system then differs by a constant, which
    ///                  the null space allows.
    /// @throws NumericsError if the factorisation fails.
    void factorise(const std::vector<MatrixEntry>& entries, bool singular);
    /// Place of the right-hand side; solve() replaces it by the solution.
    [[nodiscard]] std::span<double> values();
    void solve();

private:
    struct Implementation; // keeps Eigen's sparse headers out of what includes this file
    std::unique_ptr<Implementation> implementation_;
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/coarsest_solver.hpp"

#include "core/base/error.hpp"
#include <Eigen/SparseCholesky>

namespace physics {

struct CoarsestSolver::Implementation {
    Eigen::SparseMatrix<double> matrix;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
    Eigen::VectorXd right, work;
    std::vector<int> place; // flat place of each row
    std::vector<int> row;   // row of each flat place
    std::vector<Eigen::Triplet<double>> entries;

    /// Entries of the lower triangle, always in the same order; values may be zero.
    void fill_entries(const LevelMesh& mesh, const SevenPoint<float>* a);
};

void CoarsestSolver::Implementation::fill_entries(const LevelMesh& mesh, const SevenPoint<float>* a)
{
    entries.clear();
    const auto couple = [&](int r, int c, double t) {
        entries.emplace_back(r, r, t);
        if (c < 0) return;
        entries.emplace_back(c, c, t);
        entries.emplace_back(std::max(r, c), std::min(r, c), -t);
    };
    for (core::LocalBlock b = 0; b < mesh.layout.blocks(); ++b) {
        const auto cells = mesh.layout.cells(b);
        const std::array<int, 3> stride{1, cells.ni, cells.ni * cells.nj};
        core::for_each_cell(cells, [&](int i, int j, int k) {
            const auto flat = std::size_t(mesh.layout.origin(b)) + std::size_t(cell_index(cells, i, j, k));
            entries.emplace_back(row[flat], row[flat], a && !a->shift.empty() ? double(a->shift[flat]) : 0.0);
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (core::Index3{i, j, k}[int(axis)] > 0)
                    couple(row[flat], row[flat - std::size_t(stride[axis])], a ? double(a->face[axis][flat]) : 0.0);
        });
    }
    for (std::size_t l = 0; l < mesh.links.size(); ++l) {
        const auto& half = mesh.halves[std::size_t(mesh.half_of[l][0])];
        couple(row[std::size_t(half.cell)], row[std::size_t(half.other)], a ? double(a->link[l]) : 0.0);
    }
}

CoarsestSolver::CoarsestSolver(const LevelMesh& mesh) : implementation_(std::make_unique<Implementation>())
{
    auto& s = *implementation_;
    s.row.assign(mesh.layout.size(), -1);
    for (core::LocalBlock b = 0; b < mesh.layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < mesh.layout.cells(b).size(); ++c) {
            s.row[std::size_t(mesh.layout.origin(b) + c)] = int(s.place.size());
            s.place.push_back(int(mesh.layout.origin(b) + c));
        }
    const auto n = Eigen::Index(s.place.size());
    s.matrix.resize(n, n);
    s.right.resize(n);
    s.work.resize(n);
    s.fill_entries(mesh, nullptr);
    s.matrix.setFromTriplets(s.entries.begin(), s.entries.end());
    s.factors.analyzePattern(s.matrix);
}

CoarsestSolver::~CoarsestSolver() = default;
CoarsestSolver::CoarsestSolver(CoarsestSolver&&) noexcept = default;
CoarsestSolver& CoarsestSolver::operator=(CoarsestSolver&&) noexcept = default;

void CoarsestSolver::factorise(const MultigridLevel& level, bool singular)
{
    auto& s = *implementation_;
    if (s.place.empty()) return;
    s.fill_entries(level.mesh, &level.matrix);
    s.matrix.setFromTriplets(s.entries.begin(), s.entries.end());
    if (singular) s.matrix.coeffRef(0, 0) += s.matrix.coeff(0, 0);
    s.factors.factorize(s.matrix);
    core::require<core::NumericsError>(s.factors.info() == Eigen::Success && s.factors.vectorD().allFinite(),
                                       "multigrid: the coarsest level has no factorisation; are there cells without any "
                                       "transmissibility, or coefficients that are not finite?");
}

void CoarsestSolver::solve(MultigridLevel& level)
{
    auto& s = *implementation_;
    if (s.place.empty()) return;
    for (std::size_t r = 0; r < s.place.size(); ++r) s.right[Eigen::Index(r)] = double(level.right[std::size_t(s.place[r])]);
    s.work.noalias() = s.factors.permutationP() * s.right;
    s.factors.matrixL().solveInPlace(s.work);
    s.work.array() /= s.factors.vectorD().array();
    s.factors.matrixU().solveInPlace(s.work);
    s.right.noalias() = s.factors.permutationPinv() * s.work;
    for (std::size_t r = 0; r < s.place.size(); ++r) level.solution[std::size_t(s.place[r])] = float(s.right[Eigen::Index(r)]);
}

} // namespace physics

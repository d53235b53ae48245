// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/coarsest_solver.hpp"

#include <algorithm>

namespace physics {

CoarsestSolver::CoarsestSolver(const LevelMesh& mesh) : row_(mesh.layout.size(), -1)
{
    for (core::LocalBlock b = 0; b < mesh.layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < mesh.layout.cells(b).size(); ++c) {
            row_[std::size_t(mesh.layout.origin(b) + c)] = int(place_.size());
            place_.push_back(int(mesh.layout.origin(b) + c));
        }
    fill_entries(mesh, nullptr);
    factors_.analyse(int(place_.size()), entries_);
}

void CoarsestSolver::fill_entries(const LevelMesh& mesh, const SevenPoint<float>* a)
{
    entries_.clear();
    const auto couple = [&](int r, int c, double t) {
        entries_.emplace_back(r, r, t);
        if (c < 0) return;
        entries_.emplace_back(c, c, t);
        entries_.emplace_back(std::max(r, c), std::min(r, c), -t);
    };
    for (core::LocalBlock b = 0; b < mesh.layout.blocks(); ++b) {
        const auto cells = mesh.layout.cells(b);
        const std::array<int, 3> stride{1, cells.ni, cells.ni * cells.nj};
        core::for_each_cell(cells, [&](int i, int j, int k) {
            const auto flat = std::size_t(mesh.layout.origin(b)) + std::size_t(cell_index(cells, i, j, k));
            entries_.emplace_back(row_[flat], row_[flat], a && !a->shift.empty() ? double(a->shift[flat]) : 0.0);
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (core::Index3{i, j, k}[int(axis)] > 0)
                    couple(row_[flat], row_[flat - std::size_t(stride[axis])], a ? double(a->face[axis][flat]) : 0.0);
        });
    }
    for (std::size_t l = 0; l < mesh.links.size(); ++l) {
        const auto& half = mesh.halves[std::size_t(mesh.half_of[l][0])];
        couple(row_[std::size_t(half.cell)], row_[std::size_t(half.other)], a ? double(a->link[l]) : 0.0);
    }
}

void CoarsestSolver::factorise(const MultigridLevel& level, bool singular)
{
    fill_entries(level.mesh, &level.matrix);
    factors_.factorise(entries_, singular);
}

void CoarsestSolver::solve(MultigridLevel& level)
{
    const auto values = factors_.values();
    for (std::size_t r = 0; r < place_.size(); ++r) values[r] = double(level.right[std::size_t(place_[r])]);
    factors_.solve();
    for (std::size_t r = 0; r < place_.size(); ++r) level.solution[std::size_t(place_[r])] = float(values[r]);
}

} // namespace physics

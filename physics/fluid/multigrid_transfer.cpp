// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_transfer.hpp"

#include <algorithm>

namespace physics {
namespace {

/// Coarse neighbour next to fine cell n of `fine`; the parent itself where there is none or where it was not halved.
int near_neighbour(int n, int fine, int coarse)
{
    const int parent = n / 2;
    if (n % 2 == 1) return std::min(parent + 1, coarse - 1);
    return n + 1 == fine ? parent : std::max(parent - 1, 0);
}

/// x[i] += (parent + near neighbour along i + e[i / 2] + f[i / 2]) / 4 for one row of n cells.
void prolong_row(int n, const float* parent, const float* e, const float* f, float* x)
{
    const int pairs = n / 2, coarse = (n + 1) / 2;
    x[0] += 0.25F * (parent[0] + parent[0] + e[0] + f[0]);
#pragma omp simd
    for (int c = 1; c < pairs; ++c) x[2 * c] += 0.25F * (parent[c] + parent[c - 1] + e[c] + f[c]);
#pragma omp simd
    for (int c = 0; c < coarse - 1; ++c) x[2 * c + 1] += 0.25F * (parent[c] + parent[c + 1] + e[c] + f[c]);
    const int c = coarse - 1;
    if (n > 1) x[n - 1] += 0.25F * (parent[c] + parent[c] + e[c] + f[c]);
}

/// sum[c] += r[2 c] + r[2 c + 1] for one row of n cells.
void add_pairs(int n, const float* r, float* sum)
{
    const int pairs = n / 2;
#pragma omp simd
    for (int c = 0; c < pairs; ++c) sum[c] += r[2 * c] + r[2 * c + 1];
    if (n % 2 != 0) sum[pairs] += r[n - 1];
}

/// Adds to the children next to the side of a run what the neighbours beyond it change.
void correct_children(const MultigridLevel& coarse, const SideRun& run, core::Extents fine, core::View<float> x)
{
    const auto cells = coarse.mesh.layout.cells(run.block);
    const auto place = cell_place(cells, run.cell);
    const int axis = axis_of(run.side), n = fine[axis];
    if (n == 1 || (is_high(run.side) && n % 2 != 0)) return;
    float sum = 0.0F, weight = 0.0F;
    for (int h = run.first; h < run.last; ++h) {
        const auto& half = coarse.mesh.halves[std::size_t(h)];
        const float t = coarse.matrix.half[std::size_t(h)];
        sum += t * (coarse.solution[std::size_t(half.other)] - coarse.solution[std::size_t(half.cell)]);
        weight += t;
    }
    if (weight <= 0.0F) return;
    core::Index3 low{2 * place.i, 2 * place.j, 2 * place.k};
    core::Index3 high{std::min(low.i + 2, fine.ni), std::min(low.j + 2, fine.nj), std::min(low.k + 2, fine.nk)};
    low[axis] = is_high(run.side) ? n - 1 : 0;
    high[axis] = low[axis] + 1;
    core::for_each(low, high, [&](int i, int j, int k) { x(i, j, k) += 0.25F * (sum / weight); });
}

} // namespace

void compute_residual(const core::Team& team, MultigridLevel& level)
{
    level.mesh.layout.for_pieces(team, [&](int n) {
        residual(level.mesh, level.matrix, n, level.right.data(), level.solution.data(), level.residual.data());
    });
}

void restrict_residual(const core::Team& team, const MultigridLevel& fine, MultigridLevel& coarse)
{
    const auto& layout = coarse.mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        const auto b = coarse.fine_block[std::size_t(piece.block)];
        if (b < 0) return;
        const auto cells = layout.cells(piece.block), fine_cells = fine.mesh.layout.cells(b);
        const float* r = fine.residual.data() + fine.mesh.layout.origin(b);
        for (int row = piece.first(cells.nj * cells.nk); row < piece.last(cells.nj * cells.nk); ++row) {
            float* sum = coarse.right.data() + layout.origin(piece.block) + std::ptrdiff_t(row) * cells.ni;
            std::fill_n(sum, cells.ni, 0.0F);
            const int j = 2 * (row % cells.nj), k = 2 * (row / cells.nj);
            for (int kk = k; kk < std::min(k + 2, fine_cells.nk); ++kk)
                for (int jj = j; jj < std::min(j + 2, fine_cells.nj); ++jj)
                    add_pairs(fine_cells.ni, r + std::ptrdiff_t(fine_cells.ni) * (jj + std::ptrdiff_t(fine_cells.nj) * kk), sum);
        }
    });
}

void prolong_correction(const core::Team& team, const MultigridLevel& coarse, MultigridLevel& fine)
{
    const auto& layout = fine.mesh.layout;
    std::vector<float>& x = fine.solution;
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        const auto b = fine.coarse_block[std::size_t(piece.block)];
        const auto cells = layout.cells(piece.block), above = coarse.mesh.layout.cells(b);
        const float* e = coarse.solution.data() + coarse.mesh.layout.origin(b);
        const auto row_of = [&](int j, int k) { return e + std::ptrdiff_t(above.ni) * (j + std::ptrdiff_t(above.nj) * k); };
        for (int row = piece.first(cells.nj * cells.nk); row < piece.last(cells.nj * cells.nk); ++row) {
            const int j = row % cells.nj, k = row / cells.nj;
            prolong_row(cells.ni, row_of(j / 2, k / 2), row_of(near_neighbour(j, cells.nj, above.nj), k / 2),
                        row_of(j / 2, near_neighbour(k, cells.nk, above.nk)),
                        x.data() + layout.origin(piece.block) + std::ptrdiff_t(row) * cells.ni);
        }
    });
    team.run(layout.blocks(), [&](int fine_block) {
        const auto b = fine.coarse_block[std::size_t(fine_block)];
        const auto cells = layout.cells(fine_block);
        const core::View<float> children(x.data() + layout.origin(fine_block), cells, 0);
        const auto& mesh = coarse.mesh;
        for (int r = mesh.block_runs[std::size_t(b)]; r < mesh.block_runs[std::size_t(b) + 1]; ++r)
            correct_children(coarse, mesh.runs[std::size_t(r)], cells, children);
    });
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_transfer.hpp"

#include <algorithm>

namespace physics {
namespace {

/// Coarse neighbour beyond the side at which fine cell n lies within its parent, and the number of that side (0 low,
/// 1 high) along its axis. Where there is none the weight is zero and the neighbour is the parent.
struct Near {
    int neighbour = 0, side = 0;
};
Near near(int n, int coarse)
{
    const int parent = n / 2;
    return n % 2 == 1 ? Near{std::min(parent + 1, coarse - 1), 1} : Near{std::max(parent - 1, 0), 0};
}

/// One row of a coarse level: values and weights of the parents, values of the neighbours along j and k.
struct CoarseRow {
    const float *parent, *low, *high; // values, weights towards i_low and i_high
    const float *beyond_j, *beyond_k; // values of the nearest neighbours
    const float *weight_j, *weight_k;
    [[nodiscard]] float across(int c) const { return weight_j[c] * (beyond_j[c] - parent[c]) + weight_k[c] * (beyond_k[c] - parent[c]); }
};

/// Adds the interpolated correction to a fine row of n cells.
void prolong_row(int n, const CoarseRow& row, float* x)
{
    const int pairs = n / 2;
#pragma omp simd
    for (int c = 0; c < pairs; ++c) { // weights are zero at the ends of a row, whatever lies beyond
        const float here = row.parent[c], base = here + row.across(c);
        x[2 * c] += base + row.low[c] * (row.parent[c - 1] - here);
        x[2 * c + 1] += base + row.high[c] * (row.parent[c + 1] - here);
    }
    if (n % 2 != 0) x[n - 1] += row.parent[pairs] + row.across(pairs);
}

/// Sums over the children of each parent of a row, as they grow with each fine row.
struct ChildSums {
    float *all, *i_low, *i_high, *side_j, *side_k;

    void add(int n, const float* r) const
    {
        const int pairs = n / 2;
#pragma omp simd
        for (int c = 0; c < pairs; ++c) {
            const float low = r[2 * c], high = r[2 * c + 1], both = low + high;
            all[c] += both;
            i_low[c] += low;
            i_high[c] += high;
            side_j[c] += both;
            side_k[c] += both;
        }
        if (n % 2 == 0) return;
        all[pairs] += r[n - 1];
        side_j[pairs] += r[n - 1];
        side_k[pairs] += r[n - 1];
    }
};

/// Sums of the residuals of the children of a piece of the coarse level.
void sum_children(const Piece& piece, const MultigridLevel& fine, core::LocalBlock fine_block, MultigridLevel& coarse)
{
    const auto cells = coarse.mesh.layout.cells(piece.block), below = fine.mesh.layout.cells(fine_block);
    const float* r = fine.residual.data() + fine.mesh.layout.origin(fine_block);
    std::fill(coarse.right.begin() + piece.begin, coarse.right.begin() + piece.end, 0.0F);
    for (auto& part : coarse.side_part) std::fill(part.begin() + piece.begin, part.begin() + piece.end, 0.0F);
    for (int row = piece.first(cells.nj * cells.nk); row < piece.last(cells.nj * cells.nk); ++row) {
        const auto at = coarse.mesh.layout.origin(piece.block) + std::ptrdiff_t(row) * cells.ni;
        const int j = 2 * (row % cells.nj), k = 2 * (row / cells.nj);
        auto& part = coarse.side_part;
        for (int kk = k; kk < std::min(k + 2, below.nk); ++kk)
            for (int jj = j; jj < std::min(j + 2, below.nj); ++jj)
                ChildSums{coarse.right.data() + at, part[0].data() + at, part[1].data() + at, part[std::size_t(2 + jj % 2)].data() + at,
                          part[std::size_t(4 + kk % 2)].data() + at}
                    .add(below.ni, r + std::ptrdiff_t(below.ni) * (jj + std::ptrdiff_t(below.nj) * kk));
    }
    for (std::size_t side = 0; side < 6; ++side) {
        float* part = coarse.side_part[side].data();
        const float* weight = coarse.weight[side].data();
#pragma omp simd
        for (auto c = piece.begin; c < piece.end; ++c) part[c] *= weight[c];
    }
}

/// Residual that goes beyond the sides of a block.
void sum_beside_links(const MultigridLevel& fine, core::LocalBlock block, MultigridLevel& coarse)
{
    const auto& mesh = coarse.mesh;
    for (int n = mesh.block_runs[std::size_t(block)]; n < mesh.block_runs[std::size_t(block) + 1]; ++n) {
        const auto& run = mesh.runs[std::size_t(n)];
        const auto& children = coarse.side_children[std::size_t(n)];
        float sum = 0.0F;
        for (int c = 0; c < children.count; ++c) sum += fine.residual[std::size_t(children.at[std::size_t(c)])];
        for (int h = run.first; h < run.last; ++h) coarse.half_part[std::size_t(h)] = coarse.half_weight[std::size_t(h)] * sum;
    }
}

/// Adds to the children next to a side what the neighbours beyond it change.
void correct_beside_links(const MultigridLevel& coarse, core::LocalBlock block, std::vector<float>& x)
{
    const auto& mesh = coarse.mesh;
    for (int n = mesh.block_runs[std::size_t(block)]; n < mesh.block_runs[std::size_t(block) + 1]; ++n) {
        const auto& run = mesh.runs[std::size_t(n)];
        float change = 0.0F;
        for (int h = run.first; h < run.last; ++h) {
            const auto& half = mesh.halves[std::size_t(h)];
            change +=
                coarse.half_weight[std::size_t(h)] * (coarse.solution[std::size_t(half.other)] - coarse.solution[std::size_t(half.cell)]);
        }
        const auto& children = coarse.side_children[std::size_t(n)];
        for (int c = 0; c < children.count; ++c) x[std::size_t(children.at[std::size_t(c)])] += change;
    }
}

} // namespace

void compute_residual(const core::Team& team, MultigridLevel& level)
{
    level.mesh.layout.for_pieces(
        team, [&](int n) { residual(level.mesh, level.matrix, n, level.right.data(), level.solution.data(), level.residual.data()); });
}

void gather_children(const core::Team& team, const MultigridLevel& fine, MultigridLevel& coarse)
{
    const auto& layout = coarse.mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        const auto b = coarse.fine_block[std::size_t(piece.block)];
        if (b < 0) return;
        sum_children(piece, fine, b, coarse);
        if (piece.part == 0) sum_beside_links(fine, piece.block, coarse);
    });
}

void share_inside(const core::Team& team, MultigridLevel& coarse)
{
    const auto& layout = coarse.mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        if (coarse.fine_block[std::size_t(piece.block)] < 0) return;
        const auto cells = layout.cells(piece.block);
        const std::array<std::ptrdiff_t, 3> stride{1, cells.ni, std::ptrdiff_t(cells.ni) * cells.nj};
        float* b = coarse.right.data();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float *low = coarse.side_part[2 * axis].data(), *high = coarse.side_part[2 * axis + 1].data();
            const auto s = stride[axis];
#pragma omp simd
            for (auto c = piece.begin; c < piece.end; ++c) b[c] += (high[c - s] - low[c]) + (low[c + s] - high[c]);
        }
    });
}

void share_over_links(const core::Team& team, MultigridLevel& coarse)
{
    const auto& mesh = coarse.mesh;
    mesh.layout.for_pieces(team, [&](int n) {
        for (int h = mesh.piece_halves[std::size_t(n)]; h < mesh.piece_halves[std::size_t(n) + 1]; ++h) {
            const auto& half = mesh.halves[std::size_t(h)];
            const float taken = half.partner >= 0 ? coarse.half_part[std::size_t(half.partner)] : coarse.half_received[std::size_t(h)];
            coarse.right[std::size_t(half.cell)] += taken - coarse.half_part[std::size_t(h)];
        }
    });
}

void prolong_correction(const core::Team& team, const MultigridLevel& coarse, MultigridLevel& fine)
{
    const auto& layout = fine.mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        const auto b = fine.coarse_block[std::size_t(piece.block)];
        const auto cells = layout.cells(piece.block), above = coarse.mesh.layout.cells(b);
        const auto place = [&, origin = coarse.mesh.layout.origin(b)](int j, int k) {
            return origin + std::ptrdiff_t(above.ni) * (j + std::ptrdiff_t(above.nj) * k);
        };
        const float* e = coarse.solution.data();
        for (int row = piece.first(cells.nj * cells.nk); row < piece.last(cells.nj * cells.nk); ++row) {
            const int j = row % cells.nj, k = row / cells.nj;
            const auto near_j = near(j, above.nj), near_k = near(k, above.nk);
            const auto c = place(j / 2, k / 2);
            prolong_row(cells.ni,
                        {e + c, coarse.weight[0].data() + c, coarse.weight[1].data() + c, e + place(near_j.neighbour, k / 2),
                         e + place(j / 2, near_k.neighbour), coarse.weight[std::size_t(2 + near_j.side)].data() + c,
                         coarse.weight[std::size_t(4 + near_k.side)].data() + c},
                        fine.solution.data() + layout.origin(piece.block) + std::ptrdiff_t(row) * cells.ni);
        }
    });
    team.run(layout.blocks(), [&](int b) { correct_beside_links(coarse, fine.coarse_block[std::size_t(b)], fine.solution); });
}

} // namespace physics

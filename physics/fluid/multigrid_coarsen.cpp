// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_coarsen.hpp"

#include <algorithm>

namespace physics {
namespace {

/// The finer block seen by its coarse block.
struct Pair {
    const MultigridLevel& fine;
    core::LocalBlock block;
    core::Extents cells;
    std::ptrdiff_t origin;
    std::array<std::ptrdiff_t, 3> stride;

    Pair(const MultigridLevel& f, core::LocalBlock b)
        : fine(f),
          block(b),
          cells(f.mesh.layout.cells(b)),
          origin(f.mesh.layout.origin(b)),
          stride{1, cells.ni, std::ptrdiff_t(cells.ni) * cells.nj}
    {
    }
    [[nodiscard]] std::ptrdiff_t flat(core::Index3 c) const { return origin + c.i + stride[1] * c.j + stride[2] * c.k; }
};

/// Conductor between two coarse cells: for each fine face between them its resistance and half of those on either side.
struct Conductor {
    float conductance = 0.0F;
    float below = 0.0F, above = 0.0F; ///< sums of conductance times the half cell's share of the resistance

    void add(float resistance, float half_below, float half_above)
    {
        const float g = 1.0F / (resistance + (half_below + half_above));
        conductance += g;
        below += share(g, half_below);
        above += share(g, half_above);
    }
    [[nodiscard]] static float share(float g, float half) { return g > 0.0F ? g * (half * g) : 0.0F; }
};

/// Bounded so that no parent gets a negative weight: three differences add up in a child.
float transfer_weight(float share, float conductance) { return conductance > 0.0F ? std::min(share / conductance, 1.0F / 3.0F) : 0.0F; }

Conductor coarse_face(const Pair& p, int axis, core::Index3 coarse)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const float* t = p.fine.matrix.face[std::size_t(axis)].data();
    const auto s = p.stride[std::size_t(axis)];
    core::Index3 c{2 * coarse.i, 2 * coarse.j, 2 * coarse.k};
    const bool pair_above = c[axis] + 1 < p.cells[axis];
    const int u_end = std::min(c[u] + 2, p.cells[u]), v_end = std::min(c[v] + 2, p.cells[v]);
    Conductor sum;
    for (int cv = c[v]; cv < v_end; ++cv)
        for (int cu = c[u]; cu < u_end; ++cu) {
            core::Index3 face = c;
            face[u] = cu;
            face[v] = cv;
            const auto f = p.flat(face);
            sum.add(1.0F / t[f], 0.5F / t[f - s], pair_above ? 0.5F / t[f + s] : 0.0F);
        }
    return sum;
}

/// Coefficient of the low face of a coarse cell, and the transfer weights on both sides of it.
void set_face(MultigridLevel& coarse, const Pair& pair, core::Index3 place, int axis, std::size_t c)
{
    const auto cells = coarsened(pair.cells);
    const auto below = c - std::size_t(axis == 0 ? 1 : axis == 1 ? cells.ni : cells.ni * cells.nj);
    const auto face = coarse_face(pair, axis, place);
    coarse.matrix.face[std::size_t(axis)][c] = face.conductance;
    coarse.weight[std::size_t(2 * axis)][c] = transfer_weight(face.above, face.conductance);
    coarse.weight[std::size_t(2 * axis + 1)][below] = transfer_weight(face.below, face.conductance);
}

float coarse_shift(const Pair& p, core::Index3 coarse)
{
    const core::Index3 low{2 * coarse.i, 2 * coarse.j, 2 * coarse.k};
    const core::Index3 high{std::min(low.i + 2, p.cells.ni), std::min(low.j + 2, p.cells.nj), std::min(low.k + 2, p.cells.nk)};
    float sum = 0.0F;
    core::for_each(low, high, [&](int i, int j, int k) { sum += p.fine.matrix.shift[std::size_t(p.flat({i, j, k}))]; });
    return sum;
}

/// Half of the resistance of the face inside the parent of the run's cell, across the run's axis; 0 if there is none.
float half_resistance(const Pair& p, const SideRun& run)
{
    const int axis = axis_of(run.side), n = p.cells[axis];
    const auto s = p.stride[std::size_t(axis)];
    const auto c = p.origin + run.cell;
    const auto& t = p.fine.matrix.face[std::size_t(axis)];
    if (n < 2 || (is_high(run.side) && n % 2 != 0)) return 0.0F;
    return 0.5F / (is_high(run.side) ? t[std::size_t(c)] : t[std::size_t(c + s)]);
}

} // namespace

void link_end_resistances(const core::Team& team, MultigridLevel& fine)
{
    const auto& mesh = fine.mesh;
    team.run(mesh.layout.blocks(), [&](int b) {
        const Pair pair(fine, b);
        for (int r = mesh.block_runs[std::size_t(b)]; r < mesh.block_runs[std::size_t(b) + 1]; ++r) {
            const auto& run = mesh.runs[std::size_t(r)];
            const float resistance = half_resistance(pair, run);
            float sum = 0.0F;
            for (int h = run.first; h < run.last; ++h) sum += fine.matrix.half[std::size_t(h)];
            for (int h = run.first; h < run.last; ++h) {
                const int link = mesh.halves[std::size_t(h)].link;
                const std::size_t end = mesh.half_of[std::size_t(link)][0] == h ? 0 : 1;
                const float part = fine.matrix.half[std::size_t(h)];
                fine.end_resistance[std::size_t(link)][end] = resistance > 0.0F && part > 0.0F ? resistance * (sum / part) : 0.0F;
            }
        }
    });
}

void coarsen_coefficients(const core::Team& team, const MultigridLevel& fine, MultigridLevel& coarse)
{
    const auto& layout = coarse.mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        const auto fine_block = coarse.fine_block[std::size_t(piece.block)];
        if (fine_block < 0) return;
        const Pair pair(fine, fine_block);
        const auto cells = layout.cells(piece.block);
        auto c = std::size_t(piece.begin);
        for (int row = piece.first(cells.nj * cells.nk); row < piece.last(cells.nj * cells.nk); ++row)
            for (int i = 0; i < cells.ni; ++i, ++c) {
                const core::Index3 place{i, row % cells.nj, row / cells.nj};
                for (int axis = 0; axis < 3; ++axis)
                    if (place[axis] > 0) set_face(coarse, pair, place, axis, c);
                if (!coarse.matrix.shift.empty()) coarse.matrix.shift[c] = coarse_shift(pair, place);
            }
    });
}

void coarsen_links(const MultigridLevel& fine, MultigridLevel& coarse)
{
    std::fill(coarse.matrix.link.begin(), coarse.matrix.link.end(), 0.0F);
    std::fill(coarse.half_weight.begin(), coarse.half_weight.end(), 0.0F);
    for (std::size_t l = 0; l < fine.mesh.links.size(); ++l) {
        const auto [to, turned] = fine.mesh.coarse_link[l];
        if (to < 0) continue;
        const auto& half = fine.end_resistance[l];
        Conductor c;
        c.add(1.0F / fine.matrix.link[l], half[0], half[1]);
        coarse.matrix.link[std::size_t(to)] += c.conductance;
        const auto& ends = coarse.mesh.half_of[std::size_t(to)];
        if (const int h = ends[turned ? 1 : 0]; h >= 0) coarse.half_weight[std::size_t(h)] += c.below;
        if (const int h = ends[turned ? 0 : 1]; h >= 0) coarse.half_weight[std::size_t(h)] += c.above;
    }
}

void finish_links(MultigridLevel& coarse)
{
    spread_links(coarse);
    for (const auto& run : coarse.mesh.runs) {
        float sum = 0.0F;
        for (int h = run.first; h < run.last; ++h) sum += coarse.matrix.half[std::size_t(h)];
        for (int h = run.first; h < run.last; ++h) {
            auto& w = coarse.half_weight[std::size_t(h)];
            const float t = coarse.matrix.half[std::size_t(h)];
            w = t > 0.0F ? transfer_weight(w, t) * (t / sum) : 0.0F;
        }
    }
}

void spread_links(MultigridLevel& level)
{
    for (std::size_t h = 0; h < level.mesh.halves.size(); ++h)
        level.matrix.half[h] = level.matrix.link[std::size_t(level.mesh.halves[h].link)];
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The conservative 7-point operator with links between blocks: coefficients in flat arrays and its kernels.
// Net flow out of a cell: sum of T (x_cell - x_other) + shift x_cell.
#include "core/field/field.hpp"
#include "physics/fluid/multigrid_mesh.hpp"
#include <array>
#include <span>
#include <vector>

namespace physics {

/// Transmissibilities of one level; arrays are flat as in BlockLayout.
template <class Real>
struct SevenPoint {
    std::array<std::vector<Real>, 3> face; ///< of the low faces; zero on the boundary of a block
    std::vector<Real> shift;               ///< empty if there is none
    std::vector<Real> link;                ///< of each link
    std::vector<Real> half;                ///< the same in the order of the half links
};

template <class Real>
[[nodiscard]] SevenPoint<Real> make_seven_point(const LevelMesh& mesh, bool with_shift)
{
    SevenPoint<Real> a;
    for (auto& face : a.face) face.assign(mesh.layout.size(), Real(0));
    if (with_shift) a.shift.assign(mesh.layout.size(), Real(0));
    a.link.assign(mesh.links.size(), Real(0));
    a.half.assign(mesh.halves.size(), Real(0));
    return a;
}

/// out = finish(cell, net outflow of x through the faces inside the block), then add(out, net outflow by shift or half link).
template <class Real, class Finish, class Add>
void sweep_seven_point(const LevelMesh& mesh, const SevenPoint<Real>& a, int piece, const Real* x, Real* out, Finish finish, Add add)
{
    const auto& p = mesh.layout.pieces()[std::size_t(piece)];
    const auto cells = mesh.layout.cells(p.block);
    const std::ptrdiff_t row = cells.ni, plane = row * cells.nj;
    const Real *ti = a.face[0].data(), *tj = a.face[1].data(), *tk = a.face[2].data();
#pragma omp simd
    for (std::ptrdiff_t c = p.begin; c < p.end; ++c) {
        const Real v = x[c];
        out[c] = finish(c, ti[c] * (v - x[c - 1]) + ti[c + 1] * (v - x[c + 1]) + tj[c] * (v - x[c - row]) + tj[c + row] * (v - x[c + row]) +
                               tk[c] * (v - x[c - plane]) + tk[c + plane] * (v - x[c + plane]));
    }
    if (!a.shift.empty()) {
        const Real* shift = a.shift.data();
#pragma omp simd
        for (std::ptrdiff_t c = p.begin; c < p.end; ++c) out[c] = add(out[c], shift[c] * x[c]);
    }
    for (int h = mesh.piece_halves[std::size_t(piece)]; h < mesh.piece_halves[std::size_t(piece) + 1]; ++h) {
        const auto& half = mesh.halves[std::size_t(h)];
        out[half.cell] = add(out[half.cell], a.half[std::size_t(h)] * (x[half.cell] - x[half.other]));
    }
}

/// Writes base - (net outflow of x) for the cells of a piece; out may be base, but not x.
template <class Real>
void residual(const LevelMesh& mesh, const SevenPoint<Real>& a, int piece, const Real* base, const Real* x, Real* out)
{
    sweep_seven_point(
        mesh, a, piece, x, out, [base](std::ptrdiff_t c, Real outflow) { return base[c] - outflow; },
        [](Real sum, Real outflow) { return sum - outflow; });
}

/// Writes the net outflow of x for the cells of a piece.
template <class Real>
void net_outflow(const LevelMesh& mesh, const SevenPoint<Real>& a, int piece, const Real* x, Real* out)
{
    sweep_seven_point(
        mesh, a, piece, x, out, [](std::ptrdiff_t, Real outflow) { return outflow; }, [](Real sum, Real outflow) { return sum + outflow; });
}

/// Sums of the coefficients of each cell, those of the faces across `skipped_axis` left out (3: none, the diagonal).
template <class Real>
void coefficient_sums(const LevelMesh& mesh, const SevenPoint<Real>& a, int piece, int skipped_axis, Real* out)
{
    const auto& p = mesh.layout.pieces()[std::size_t(piece)];
    const auto cells = mesh.layout.cells(p.block);
    const std::array<std::ptrdiff_t, 3> stride{1, cells.ni, std::ptrdiff_t(cells.ni) * cells.nj};
    for (std::ptrdiff_t c = p.begin; c < p.end; ++c) out[c] = a.shift.empty() ? Real(0) : a.shift[std::size_t(c)];
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == skipped_axis) continue;
        const Real* t = a.face[std::size_t(axis)].data();
        const auto s = stride[std::size_t(axis)];
        for (std::ptrdiff_t c = p.begin; c < p.end; ++c) out[c] += t[c] + t[c + s];
    }
    for (int h = mesh.piece_halves[std::size_t(piece)]; h < mesh.piece_halves[std::size_t(piece) + 1]; ++h)
        out[mesh.halves[std::size_t(h)].cell] += a.half[std::size_t(h)];
}

/// Coefficients of the finest level from the fields of the step.
struct Coefficients {
    const core::FaceField* face = nullptr;    ///< values on the boundary of a block are ignored
    std::span<const double> link;             ///< as BlockTopology::links was given
    const core::ScalarField* shift = nullptr; ///< added to the diagonal; may be null
};

/// Copies coefficients into flat arrays, for one piece of the layout.
void copy_coefficients(const LevelMesh& mesh, const Coefficients& from, int piece, SevenPoint<double>& to);
/// Copies the transmissibilities of the links.
/// @param source  See canonical_links().
void copy_links(const LevelMesh& mesh, const Coefficients& from, std::span<const int> source, SevenPoint<double>& to);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_smoother.hpp"

#include "physics/fluid/multigrid_lines.hpp"
#include <algorithm>

namespace physics {
namespace {

struct Anisotropy {
    LineAxis strongest = LineAxis::none;
    double ratio = 1.0; ///< largest over smallest of the mean shares of the axes
};

/// Mean share of each axis in the coefficients of the cells of a block.
Anisotropy anisotropy(const MultigridLevel& level, core::LocalBlock b)
{
    const auto cells = level.mesh.layout.cells(b);
    const auto origin = level.mesh.layout.origin(b);
    const std::array<std::ptrdiff_t, 3> stride{1, cells.ni, std::ptrdiff_t(cells.ni) * cells.nj};
    std::array<double, 3> share{};
    for (auto c = origin; c < origin + cells.size(); ++c) {
        std::array<float, 3> t{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            t[axis] = level.matrix.face[axis][std::size_t(c)] + level.matrix.face[axis][std::size_t(c + stride[axis])];
        const float sum = t[0] + t[1] + t[2];
        if (sum <= 0.0F) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) share[axis] += double(t[axis] / sum);
    }
    Anisotropy result;
    double largest = 0.0, smallest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (cells[axis] < 2) continue;
        const double mean = share[std::size_t(axis)] * cells[axis] / (cells[axis] - 1); // no faces beyond the ends
        if (mean > largest) result.strongest = static_cast<LineAxis>(axis);
        largest = std::max(largest, mean);
        smallest = smallest == 0.0 ? mean : std::min(smallest, mean);
    }
    if (smallest > 0.0) result.ratio = largest / smallest;
    return result;
}

LineAxis chosen_axis(Smoother kind, const Anisotropy& a)
{
    constexpr double worth_lines = 3.0; // points smooth coefficients in this ratio about as well as equal ones
    if (kind == Smoother::point || (kind == Smoother::automatic && a.ratio < worth_lines)) return LineAxis::none;
    return a.strongest;
}

template <class Update>
void correct(const core::Team& team, MultigridLevel& level, const std::vector<float>& from, Update update)
{
    level.mesh.layout.for_pieces(team, [&](int n) {
        const auto& piece = level.mesh.layout.pieces()[std::size_t(n)];
        residual(level.mesh, level.matrix, n, level.right.data(), from.data(), level.residual.data());
        if (level.axis[std::size_t(piece.block)] != LineAxis::none) return;
        solve_lines(piece, level, level.residual.data());
        update(piece.begin, piece.end);
    });
    if (!level.has_lines) return;
    level.mesh.layout.for_pieces(team, [&](int n) {
        const auto& piece = level.mesh.layout.pieces()[std::size_t(n)];
        const auto axis = level.axis[std::size_t(piece.block)];
        if (axis == LineAxis::none) return;
        solve_lines(piece, level, level.residual.data());
        for_line_ranges(piece, level.mesh.layout, axis, update);
    });
}

} // namespace

ChebyshevWeights chebyshev_weights(double largest, double ratio)
{
    const double middle = 0.5 * (largest + largest / ratio), half_width = 0.5 * (largest - largest / ratio);
    const double rho = half_width / middle, next = 1.0 / (2.0 * middle / half_width - rho);
    return {float(1.0 / middle), float(next * rho), float(2.0 * next / half_width)};
}

void prepare_smoother(const core::Team& team, Smoother kind, MultigridLevel& level)
{
    const auto& layout = level.mesh.layout;
    team.run(layout.blocks(), [&](int b) { level.axis[std::size_t(b)] = chosen_axis(kind, anisotropy(level, b)); });
    level.has_lines = std::any_of(level.axis.begin(), level.axis.end(), [](LineAxis a) { return a != LineAxis::none; });
    layout.for_pieces(team, [&](int n) {
        const int axis = static_cast<int>(level.axis[std::size_t(layout.pieces()[std::size_t(n)].block)]);
        coefficient_sums(level.mesh, level.matrix, n, axis, level.inverse.data());
    });
    layout.for_pieces(team, [&](int n) { factorise_lines(layout.pieces()[std::size_t(n)], level); });
}

void smooth_from_zero(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    const auto& layout = level.mesh.layout;
    layout.for_pieces(team, [&, first = weights.first](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        float *z = level.residual.data(), *d = level.direction.data(), *x = level.other.data();
        const float* b = level.right.data();
        const auto axis = level.axis[std::size_t(piece.block)];
        for_line_ranges(piece, layout, axis, [&](auto begin, auto end) { std::copy(b + begin, b + end, z + begin); });
        solve_lines(piece, level, z);
        for_line_ranges(piece, layout, axis, [=](auto begin, auto end) {
#pragma omp simd
            for (auto c = begin; c < end; ++c) x[c] = d[c] = first * z[c];
        });
    });
}

void smooth_first(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    const float *z = level.residual.data(), *x = level.solution.data();
    float *d = level.direction.data(), *y = level.other.data();
    correct(team, level, level.solution, [=, first = weights.first](std::ptrdiff_t begin, std::ptrdiff_t end) {
#pragma omp simd
        for (auto c = begin; c < end; ++c) {
            d[c] = first * z[c];
            y[c] = x[c] + d[c];
        }
    });
}

void smooth_second(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    const float *z = level.residual.data(), *x = level.other.data();
    float *d = level.direction.data(), *y = level.solution.data();
    correct(team, level, level.other, [=, keep = weights.keep, second = weights.second](std::ptrdiff_t begin, std::ptrdiff_t end) {
#pragma omp simd
        for (auto c = begin; c < end; ++c) {
            d[c] = keep * d[c] + second * z[c];
            y[c] = x[c] + d[c];
        }
    });
}

} // namespace physics

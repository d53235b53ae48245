// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_smoother.hpp"

#include "physics/fluid/line_ends.hpp"
#include "physics/fluid/multigrid_lines.hpp"
#include <algorithm>

namespace physics {
namespace {

struct Anisotropy {
    LineAxis strongest = LineAxis::none;
    double ratio = 1.0; ///< largest over smallest of the mean shares of the axes
};

/// Sums of the links of each cell of a block along an axis: all that ties cells where the axis has one cell only.
void sum_links_along(const MultigridLevel& level, core::LocalBlock b, int axis, float* sum)
{
    const auto& mesh = level.mesh;
    std::fill(sum, sum + mesh.layout.cells(b).size(), 0.0F);
    for (int r = mesh.block_runs[std::size_t(b)]; r < mesh.block_runs[std::size_t(b) + 1]; ++r) {
        const auto& run = mesh.runs[std::size_t(r)];
        if (core::axis_of(run.side) != axis) continue;
        for (int h = run.first; h < run.last; ++h) sum[run.cell] += level.matrix.half[std::size_t(h)];
    }
}

/// Mean share of each axis in the coefficients of the cells of a block.
Anisotropy anisotropy(MultigridLevel& level, core::LocalBlock b)
{
    const auto cells = level.mesh.layout.cells(b);
    const auto origin = level.mesh.layout.origin(b);
    const std::array<std::ptrdiff_t, 3> stride{1, cells.ni, std::ptrdiff_t(cells.ni) * cells.nj};
    const std::array<float*, 3> scratch{level.residual.data() + origin, level.direction.data() + origin, level.other.data() + origin};
    const auto is_thin = [&](std::size_t axis) { return cells[int(axis)] == 1 && level.chains.possible(); };
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (is_thin(axis)) sum_links_along(level, b, int(axis), scratch[axis]);
    std::array<double, 3> share{};
    for (std::ptrdiff_t n = 0; n < cells.size(); ++n) {
        const auto c = origin + n;
        std::array<float, 3> t{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            t[axis] = is_thin(axis) ? scratch[axis][n]
                                    : level.matrix.face[axis][std::size_t(c)] + level.matrix.face[axis][std::size_t(c + stride[axis])];
        const float sum = t[0] + t[1] + t[2];
        if (sum <= 0.0F) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) share[axis] += double(t[axis] / sum);
    }
    Anisotropy result;
    double largest = 0.0, smallest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double mean = share[std::size_t(axis)] * (cells[axis] < 2 ? 1.0 : double(cells[axis]) / (cells[axis] - 1)); // no end faces
        if (cells[axis] < 2 && mean <= 0.0) continue;
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

/// Ends of the lines of blocks with chains, from what the lines have by themselves.
void gather_ends(const core::Team& team, MultigridLevel& level)
{
    if (!level.chains.active()) return;
    team.run(level.mesh.layout.blocks(), [&](int b) {
        if (level.in_chains(b)) gather_ends(level, b);
    });
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
        if (!level.in_chains(piece.block)) for_line_ranges(piece, level.mesh.layout, axis, update);
    });
    gather_ends(team, level);
}

/// What is left to do for blocks with chains when all ends are known.
template <class Update>
void finish(const core::Team& team, MultigridLevel& level, Update update)
{
    if (!level.chains.active()) return;
    level.chains.solve(team);
    team.run(level.mesh.layout.blocks(), [&](int b) {
        if (level.in_chains(b)) move_to_ends(level, b);
    });
    level.mesh.layout.for_pieces(team, [&](int n) {
        const auto& piece = level.mesh.layout.pieces()[std::size_t(n)];
        if (level.in_chains(piece.block)) update(piece.begin, piece.end);
    });
}

/// Writes direction and the new values of the first step from zero.
auto update_from_zero(const ChebyshevWeights& weights, MultigridLevel& level)
{
    const float* z = level.residual.data();
    float *d = level.direction.data(), *x = level.other.data();
    return [=, first = weights.first](std::ptrdiff_t begin, std::ptrdiff_t end) {
#pragma omp simd
        for (auto c = begin; c < end; ++c) x[c] = d[c] = first * z[c];
    };
}

auto update_first(const ChebyshevWeights& weights, MultigridLevel& level)
{
    const float *z = level.residual.data(), *x = level.solution.data();
    float *d = level.direction.data(), *y = level.other.data();
    return [=, first = weights.first](std::ptrdiff_t begin, std::ptrdiff_t end) {
#pragma omp simd
        for (auto c = begin; c < end; ++c) {
            d[c] = first * z[c];
            y[c] = x[c] + d[c];
        }
    };
}

auto update_second(const ChebyshevWeights& weights, MultigridLevel& level)
{
    const float *z = level.residual.data(), *x = level.other.data();
    float *d = level.direction.data(), *y = level.solution.data();
    return [=, keep = weights.keep, second = weights.second](std::ptrdiff_t begin, std::ptrdiff_t end) {
#pragma omp simd
        for (auto c = begin; c < end; ++c) {
            d[c] = keep * d[c] + second * z[c];
            y[c] = x[c] + d[c];
        }
    };
}

} // namespace

ChebyshevWeights chebyshev_weights(double largest, double ratio)
{
    const auto [one, two] = chebyshev_steps<2>(largest, ratio);
    return {one.gain, two.keep, two.gain};
}

ChebyshevWeights weights_for_firm_lines() { return {1.0F / 1.5F, 0.0F, 1.0F}; }

void choose_lines(const core::Team& team, Smoother kind, MultigridLevel& level)
{
    const auto& layout = level.mesh.layout;
    team.run(layout.blocks(), [&](int b) {
        const Anisotropy found = anisotropy(level, b);
        const auto axis = level.axis[std::size_t(b)] = chosen_axis(kind, found);
        auto& choice = level.choices[std::size_t(layout.id(b))];
        choice = {axis, axis == LineAxis::none ? 1.0 : found.ratio, {}};
        if (level.chains.possible()) choice.hold = line_hold(level, b, axis);
    });
    level.has_lines = std::any_of(level.axis.begin(), level.axis.end(), [](LineAxis a) { return a != LineAxis::none; });
}

void factorise_lines(const core::Team& team, MultigridLevel& level)
{
    const auto& layout = level.mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const int axis = static_cast<int>(level.axis[std::size_t(layout.pieces()[std::size_t(n)].block)]);
        coefficient_sums(level.mesh, level.matrix, n, axis, level.inverse.data());
    });
    level.chains.join(level.choices);
    constexpr double firm = 1000.0; // at 900 Chebyshev takes as few iterations, at 10,000 three times as many
    level.lines_are_firm = std::any_of(level.choices.begin(), level.choices.end(), [](const LineChoice& c) { return c.anisotropy > firm; });
    if (level.chains.active()) {
        level.from_low.resize(layout.size());
        level.from_high.resize(layout.size());
        team.run(layout.blocks(), [&](int b) {
            if (level.in_chains(b)) form_ports(level, b);
        });
    }
    layout.for_pieces(team, [&](int n) { factorise_lines(layout.pieces()[std::size_t(n)], level); });
}

void smooth_from_zero(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    const auto& layout = level.mesh.layout;
    const auto update = update_from_zero(weights, level);
    layout.for_pieces(team, [&](int n) {
        const auto& piece = layout.pieces()[std::size_t(n)];
        float* z = level.residual.data();
        const float* b = level.right.data();
        const auto axis = level.axis[std::size_t(piece.block)];
        for_line_ranges(piece, layout, axis, [&](auto begin, auto end) { std::copy(b + begin, b + end, z + begin); });
        solve_lines(piece, level, z);
        if (!level.in_chains(piece.block)) for_line_ranges(piece, layout, axis, update);
    });
    gather_ends(team, level);
}

void finish_from_zero(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    finish(team, level, update_from_zero(weights, level));
}

void smooth_first(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    correct(team, level, level.solution, update_first(weights, level));
}

void finish_first(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    finish(team, level, update_first(weights, level));
}

void smooth_second(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    correct(team, level, level.other, update_second(weights, level));
}

void finish_second(const core::Team& team, const ChebyshevWeights& weights, MultigridLevel& level)
{
    finish(team, level, update_second(weights, level));
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_lines.hpp"

#include <algorithm>

namespace physics {
namespace {

/// Lines side by side: `count` groups, each of `width` adjacent lines of `length` cells `stride` apart.
struct LineGroups {
    std::ptrdiff_t begin = 0, next_group = 0, stride = 1, width = 1;
    int count = 0, length = 0;
};

/// Lines along j: one group for each k-plane; along k: one group for all of the piece.
LineGroups line_groups(const Piece& p, const BlockLayout& layout, LineAxis axis)
{
    const auto c = layout.cells(p.block);
    const std::ptrdiff_t origin = layout.origin(p.block), plane = std::ptrdiff_t(c.ni) * c.nj;
    if (axis == LineAxis::j) return {origin + plane * p.first(c.nk), plane, c.ni, c.ni, p.last(c.nk) - p.first(c.nk), c.nj};
    const std::ptrdiff_t width = std::ptrdiff_t(c.ni) * (p.last(c.nj) - p.first(c.nj));
    return {origin + std::ptrdiff_t(c.ni) * p.first(c.nj), 0, plane, width, 1, c.nk};
}

/// Forward and backward substitution, the adjacent lines in SIMD lanes.
void solve_adjacent_lines(const LineGroups& g, const float* t, const float* w, float* u)
{
    for (int group = 0; group < g.count; ++group) {
        const std::ptrdiff_t begin = g.begin + group * g.next_group, s = g.stride;
        for (int n = 0; n < g.length; ++n) {
            const std::ptrdiff_t low = begin + n * s;
            if (n == 0) {
#pragma omp simd
                for (std::ptrdiff_t c = low; c < low + g.width; ++c) u[c] = w[c] * u[c];
                continue;
            }
#pragma omp simd
            for (std::ptrdiff_t c = low; c < low + g.width; ++c) u[c] = w[c] * (u[c] + t[c] * u[c - s]);
        }
        for (int n = g.length - 2; n >= 0; --n) {
            const std::ptrdiff_t low = begin + n * s;
#pragma omp simd
            for (std::ptrdiff_t c = low; c < low + g.width; ++c) u[c] += w[c] * (t[c + s] * u[c + s]);
        }
    }
}

/// Lines along i, `Rows` rows together so that their recurrences overlap in the pipeline.
template <int Rows>
void solve_rows(std::ptrdiff_t begin, int n, const float* t, const float* w, float* u)
{
    float carry[Rows] = {};
    for (std::ptrdiff_t i = begin; i < begin + n; ++i)
        for (int r = 0; r < Rows; ++r) {
            const std::ptrdiff_t c = i + std::ptrdiff_t(r) * n;
            carry[r] = w[c] * (u[c] + t[c] * carry[r]);
            u[c] = carry[r];
        }
    for (std::ptrdiff_t i = begin + n - 2; i >= begin; --i)
        for (int r = 0; r < Rows; ++r) {
            const std::ptrdiff_t c = i + std::ptrdiff_t(r) * n;
            carry[r] = u[c] + w[c] * (t[c + 1] * carry[r]);
            u[c] = carry[r];
        }
}

float inverse_or_zero(float pivot) { return pivot > 0.0F ? 1.0F / pivot : 0.0F; }

/// What a cell adds to its own ties: those of the line before it, through the face t.
float tie(float t, float before) { return t > 0.0F ? t * (before / (t + before)) : 0.0F; }

} // namespace

void factorise_lines(const Piece& piece, MultigridLevel& level)
{
    const auto axis = level.axis[std::size_t(piece.block)];
    const int ni = level.mesh.layout.cells(piece.block).ni;
    float* w = level.inverse.data();
    if (axis == LineAxis::none) {
        for (auto c = piece.begin; c < piece.end; ++c) w[c] = inverse_or_zero(w[c]);
        return;
    }
    const float* t = level.matrix.face[std::size_t(axis)].data();
    if (axis == LineAxis::i) {
        for (auto c = piece.begin; c < piece.end; ++c)
            if ((c - piece.begin) % ni != 0) w[c] += tie(t[c], w[c - 1]);
        for (auto c = piece.begin; c < piece.end; ++c) w[c] = inverse_or_zero(t[c + 1] + w[c]);
        return;
    }
    const auto g = line_groups(piece, level.mesh.layout, axis);
    for (int group = 0; group < g.count; ++group) {
        const auto begin = g.begin + group * g.next_group;
        for (int n = 1; n < g.length; ++n)
            for (auto c = begin + n * g.stride, end = c + g.width; c < end; ++c) w[c] += tie(t[c], w[c - g.stride]);
        for (int n = 0; n < g.length; ++n)
            for (auto c = begin + n * g.stride, end = c + g.width; c < end; ++c) w[c] = inverse_or_zero(t[c + g.stride] + w[c]);
    }
}

void solve_lines(const Piece& piece, const MultigridLevel& level, float* values)
{
    const auto axis = level.axis[std::size_t(piece.block)];
    const float* w = level.inverse.data();
    if (axis == LineAxis::none) {
#pragma omp simd
        for (auto c = piece.begin; c < piece.end; ++c) values[c] = w[c] * values[c];
        return;
    }
    if (axis != LineAxis::i) {
        const float* t = level.matrix.face[std::size_t(axis)].data();
        return solve_adjacent_lines(line_groups(piece, level.mesh.layout, axis), t, w, values);
    }
    const int n = level.mesh.layout.cells(piece.block).ni;
    const float* t = level.matrix.face[0].data();
    auto begin = piece.begin;
    for (; begin + 8 * std::ptrdiff_t(n) <= piece.end; begin += 8 * std::ptrdiff_t(n)) solve_rows<8>(begin, n, t, w, values);
    for (; begin < piece.end; begin += n) solve_rows<1>(begin, n, t, w, values);
}

} // namespace physics

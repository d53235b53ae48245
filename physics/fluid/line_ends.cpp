// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/line_ends.hpp"

#include <algorithm>

namespace physics {
namespace {

/// Where the lines of a block lie in the flat arrays.
struct FlatLines {
    BlockLines lines;
    std::ptrdiff_t origin = 0, along = 1, u = 1, v = 1;

    FlatLines(const BlockLayout& layout, core::LocalBlock b, LineAxis axis) : lines(layout.cells(b), axis), origin(layout.origin(b))
    {
        const auto n = layout.cells(b);
        const std::array<std::ptrdiff_t, 3> stride{1, n.ni, std::ptrdiff_t(n.ni) * n.nj};
        along = stride[std::size_t(lines.axis)];
        u = stride[std::size_t(lines.u)];
        v = stride[std::size_t(lines.v)];
    }
    [[nodiscard]] std::size_t low(int line) const { return std::size_t(origin + u * (line % lines.across) + v * (line / lines.across)); }
    [[nodiscard]] std::size_t high(int line) const { return low(line) + std::size_t(along * (lines.length - 1)); }
};

/// Coefficients of a cell across its line, without links.
float across_line(const SevenPoint<float>& a, const FlatLines& at, std::size_t cell)
{
    const float* u = a.face[std::size_t(at.lines.u)].data() + cell;
    const float* v = a.face[std::size_t(at.lines.v)].data() + cell;
    return (a.shift.empty() ? 0.0F : a.shift[cell]) + (u[0] + u[at.u]) + (v[0] + v[at.v]);
}

/// body(cell, side, sum of its links beyond that side) for all cells with links.
template <class Body>
void for_links(const MultigridLevel& level, core::LocalBlock b, Body body)
{
    const auto& mesh = level.mesh;
    for (int r = mesh.block_runs[std::size_t(b)]; r < mesh.block_runs[std::size_t(b) + 1]; ++r) {
        const auto& run = mesh.runs[std::size_t(r)];
        float sum = 0.0F;
        for (int h = run.first; h < run.last; ++h) sum += level.matrix.half[std::size_t(h)];
        body(cell_place(mesh.layout.cells(b), run.cell), run.side, sum);
    }
}

} // namespace

std::array<double, 2> line_hold(const MultigridLevel& level, core::LocalBlock b, LineAxis axis)
{
    std::array<double, 2> sum{}, count{};
    if (axis == LineAxis::none) return sum;
    const FlatLines at(level.mesh.layout, b, axis);
    for_links(level, b, [&](core::Index3 cell, core::Side side, float links) {
        if (core::axis_of(side) != at.lines.axis || links <= 0.0F) return;
        const std::size_t end = core::is_high(side) ? 1 : 0;
        const int line = at.lines.line(cell);
        sum[end] += double(links / (links + across_line(level.matrix, at, end == 1 ? at.high(line) : at.low(line))));
        count[end] += 1.0;
    });
    for (std::size_t end = 0; end < 2; ++end)
        if (count[end] > 0.0) sum[end] /= count[end];
    return sum;
}

namespace {

/// Conductances of the cells at the ends to their surroundings and to the chain beyond.
void form_end_ports(MultigridLevel& level, core::LocalBlock b, const FlatLines& at, const LineChains::Ports& ports)
{
    const BlockLines& lines = at.lines;
    for (int line = 0; line < lines.count; ++line) {
        ports.ground_low[std::size_t(line)] = across_line(level.matrix, at, at.low(line));
        ports.ground_high[std::size_t(line)] = lines.length > 1 ? across_line(level.matrix, at, at.high(line)) : 0.0F;
        ports.link_low[std::size_t(line)] = ports.link_high[std::size_t(line)] = 0.0F;
    }
    for_links(level, b, [&](core::Index3 cell, core::Side side, float links) {
        const auto line = std::size_t(lines.line(cell));
        const bool low = cell[lines.axis] == 0, high = cell[lines.axis] == lines.length - 1;
        const bool along = core::axis_of(side) == lines.axis;
        if (along && level.chains.goes_on(level.mesh.layout.id(b), cell, side))
            (core::is_high(side) ? ports.link_high : ports.link_low)[line] = links;
        else if (low) ports.ground_low[line] += links;
        else if (high) ports.ground_high[line] += links;
    });
}

/// Takes the cells between the ends out, one after the other from the low end: between the ends remain a conductance, what leaks
/// beside it, and for each cell its shares in the values of the two ends.
void form_between(MultigridLevel& level, const FlatLines& at, const LineChains::Ports& ports)
{
    const float *t = level.matrix.face[std::size_t(at.lines.axis)].data(), *across = level.inverse.data();
    float *from_low = level.from_low.data(), *from_high = level.from_high.data();
    const auto s = std::size_t(at.along);
    for (int line = 0; line < at.lines.count; ++line) {
        const std::size_t low = at.low(line), high = at.high(line), n = std::size_t(line);
        from_low[low] = from_high[high] = 1.0F;
        if (low == high) {
            from_high[low] = 0.0F;
            continue;
        }
        from_low[high] = from_high[low] = 0.0F;
        float tie = t[low + s], leak = 0.0F, at_low = 0.0F;
        for (std::size_t c = low + s; c < high; c += s) {
            leak += across[c];
            const float pivot = tie + t[c + s] + leak, inverse = pivot > 0.0F ? 1.0F / pivot : 0.0F;
            from_low[c] = tie * inverse;
            from_high[c] = t[c + s] * inverse;
            at_low += tie * (leak * inverse);
            leak = t[c + s] * (leak * inverse);
            tie = tie * (t[c + s] * inverse);
        }
        for (std::size_t c = high - s; c > low; c -= s) {
            from_low[c] += from_high[c] * from_low[c + s];
            from_high[c] *= from_high[c + s];
        }
        ports.through[n] = tie;
        ports.ground_low[n] += at_low;
        ports.ground_high[n] += leak;
    }
}

} // namespace

void form_ports(MultigridLevel& level, core::LocalBlock b)
{
    const FlatLines at(level.mesh.layout, b, level.axis[std::size_t(b)]);
    const auto ports = level.chains.ports(level.mesh.layout.id(b));
    form_end_ports(level, b, at, ports);
    form_between(level, at, ports);
}

void gather_ends(MultigridLevel& level, core::LocalBlock b)
{
    const FlatLines at(level.mesh.layout, b, level.axis[std::size_t(b)]);
    const auto id = level.mesh.layout.id(b);
    const auto ports = level.chains.ports(id);
    const auto ends = level.chains.ends(id);
    const auto count = std::size_t(at.lines.count);
    const float* z = level.residual.data();
    for (std::size_t n = 0; n < count; ++n) {
        const float low = z[at.low(int(n))], high = z[at.high(int(n))], between = ports.through[n] * (low - high);
        ends[n] = (ports.ground_low[n] + ports.link_low[n] + (at.lines.length == 1 ? ports.link_high[n] : 0.0F)) * low + between;
        ends[count + n] = (ports.ground_high[n] + ports.link_high[n]) * high - between;
    }
}

void move_to_ends(MultigridLevel& level, core::LocalBlock b)
{
    const FlatLines at(level.mesh.layout, b, level.axis[std::size_t(b)]);
    const auto ends = level.chains.ends(level.mesh.layout.id(b));
    const auto count = std::size_t(at.lines.count);
    float* z = level.residual.data();
    for (std::size_t n = 0; n < count; ++n) {
        ends[n] -= z[at.low(int(n))];
        ends[count + n] -= z[at.high(int(n))];
    }
    const float *low = ends.data(), *high = ends.data() + count;
    const float *from_low = level.from_low.data(), *from_high = level.from_high.data();
    const auto cells = level.mesh.layout.cells(b);
    for (int row = 0; row < cells.nj * cells.nk; ++row) {
        const auto begin = at.origin + std::ptrdiff_t(row) * cells.ni;
        const core::Index3 first{0, row % cells.nj, row / cells.nj};
        const int line = at.lines.line(first), step = at.lines.axis == 0 ? 0 : 1;
#pragma omp simd
        for (int i = 0; i < cells.ni; ++i)
            z[begin + i] += low[line + step * i] * from_low[begin + i] + high[line + step * i] * from_high[begin + i];
    }
}

} // namespace physics

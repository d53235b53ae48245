// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/wall_layers.hpp"
#include "core/base/error.hpp"
#include "core/grid/spacing.hpp"
#include <algorithm>

namespace core {
namespace {

Index3 moved(Index3 c, int axis, int by)
{
    c[axis] += by;
    return c;
}

double length_of(const std::vector<Vec3>& line)
{
    double length = 0;
    for (std::size_t s = 1; s < line.size(); ++s) length += (line[s] - line[s - 1]).norm();
    return length;
}

/// Share of a correction that acts at the n-th vertex from the wall: near it, where the cells are thin and follow at once.
double weight(int n)
{
    constexpr double reach = 3;
    return std::exp(-(n - 1) / reach) * (1 - std::exp(-1 / reach));
}

/// Calls body(start) for the starts of all lines along `axis`.
template <class Body>
void for_each_line(Extents vertices, int axis, Body body)
{
    Index3 high{vertices.ni, vertices.nj, vertices.nk};
    high[axis] = 1;
    for_each({0, 0, 0}, high, [&](int i, int j, int k) { body(Index3{i, j, k}); });
}

/// @throws ConfigError for impossible numbers.
std::array<WallEnds, 3> ends_of(const std::vector<WallSpacing>& wanted)
{
    std::array<WallEnds, 3> ends;
    for (const WallSpacing& wall : wanted) {
        require<ConfigError>(wall.first_cell > 0 && wall.growth >= 1, text("side ", side_words[std::size_t(wall.side)],
                                                                           " needs a first cell larger than 0 and a growth of 1 or more"));
        WallEnds& here = ends[std::size_t(axis_of(wall.side))];
        (is_high(wall.side) ? here.high : here.low) = wall;
    }
    return ends;
}

std::vector<double> shares(const std::vector<Vec3>& line, const WallEnds& ends)
{
    EndSpacing spacing;
    if (ends.low) spacing.low = ends.low->first_cell;
    if (ends.high) spacing.high = ends.high->first_cell;
    spacing.growth = std::max(ends.low ? ends.low->growth : 1.0, ends.high ? ends.high->growth : 1.0);
    try {
        return spaced(int(line.size()) - 1, length_of(line), spacing);
    } catch (const ConfigError& error) {
        throw ConfigError(text("the line from (", line.front().transpose(), ") to (", line.back().transpose(), ") m: ", error.what()));
    }
}

std::vector<Vec3> line_of(const Vertices& block, int axis, Index3 start)
{
    std::vector<Vec3> line;
    for (int s = 0; s < block.extents()[axis]; ++s) line.push_back(block.view()[moved(start, axis, s)]);
    return line;
}

} // namespace

void respace_lines(Vertices& block, const std::vector<WallSpacing>& wanted)
{
    const auto ends = ends_of(wanted);
    for (int axis = 0; axis < 3; ++axis) {
        if (!ends[std::size_t(axis)].any()) continue;
        for_each_line(block.extents(), axis, [&](Index3 start) {
            std::vector<Vec3> line = line_of(block, axis, start);
            respace(line, shares(line, ends[std::size_t(axis)]));
            for (std::size_t s = 0; s < line.size(); ++s) block.view()[moved(start, axis, int(s))] = line[s];
        });
    }
}

WallLayers::WallLayers(const Vertices& block, const std::vector<WallSpacing>& wanted, Curvature kind) : ends_(ends_of(wanted))
{
    for (const WallSpacing& wall : wanted) {
        Extents n = block.extents();
        (axis_of(wall.side) == 0 ? n.ni : axis_of(wall.side) == 1 ? n.nj : n.nk) = 1;
        correction_[std::size_t(wall.side)] = Array3<double>(n, 0, 0.0);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const WallEnds& ends = ends_[std::size_t(axis)];
        if (!ends.any()) continue;
        auto& factor = factor_[std::size_t(axis)] = Array3<double>(block.extents(), 0, 0.0);
        for_each_line(block.extents(), axis, [&](Index3 start) {
            const auto factors = factors_of(shares(line_of(block, axis, start), ends), kind);
            for (std::size_t s = 0; s < factors.size(); ++s) factor.view()[moved(start, axis, int(s))] = factors[s];
        });
    }
}

double WallLayers::correct(const Vertices& block, const WallSpacing& wall)
{
    constexpr double caution = 0.4, most = 1.5; // share of the error that one correction takes; largest correction in all
    const int axis = axis_of(wall.side), p = (axis + 1) % 3, q = (axis + 2) % 3;
    const Extents n = block.extents();
    const auto x = block.view();
    double largest = 0;
    for_each_line(n, axis, [&](Index3 start) {
        if (start[p] == 0 || start[q] == 0 || start[p] == n[p] - 1 || start[q] == n[q] - 1) return; // its line is on a side
        Index3 foot = start;
        foot[axis] = is_high(wall.side) ? n[axis] - 1 : 0;
        const Vec3 normal = (x[moved(foot, p, 1)] - x[moved(foot, p, -1)]).cross(x[moved(foot, q, 1)] - x[moved(foot, q, -1)]).normalized();
        const double height = std::abs(normal.dot(x[moved(foot, axis, is_high(wall.side) ? -1 : 1)] - x[foot]));
        double& correction = correction_[std::size_t(wall.side)].view()[start];
        const double change = std::log(wall.first_cell / std::max(height, 0.01 * wall.first_cell));
        correction = std::clamp(correction + caution * change, -most, most);
        largest = std::max(largest, std::abs(height / wall.first_cell - 1));
    });
    return largest;
}

double WallLayers::correct(const Vertices& block)
{
    double largest = 0;
    for (const WallEnds& ends : ends_)
        for (const auto& wall : {ends.low, ends.high})
            if (wall) largest = std::max(largest, correct(block, *wall));
    return largest;
}

void WallLayers::add_factors(double share, ControlFunctions& control) const
{
    for (int axis = 0; axis < 3; ++axis) {
        const WallEnds& ends = ends_[std::size_t(axis)];
        if (!ends.any()) continue;
        const Extents n = control.factor[0].extents();
        for_each_cell(n, [&](int i, int j, int k) {
            Index3 start{i, j, k};
            start[axis] = 0;
            const int from_low = Index3{i, j, k}[axis], from_high = n[axis] - 1 - from_low;
            double sum = factor_[std::size_t(axis)](i, j, k);
            if (ends.low && from_low > 0) sum += weight(from_low) * correction_[std::size_t(ends.low->side)].view()[start];
            if (ends.high && from_high > 0) sum -= weight(from_high) * correction_[std::size_t(ends.high->side)].view()[start];
            control.factor[std::size_t(axis)](i, j, k) += share * sum;
        });
    }
}

} // namespace core

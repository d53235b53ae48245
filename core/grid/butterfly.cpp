// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/butterfly.hpp"
#include "core/base/error.hpp"
#include <cmath>
#include <numbers>

namespace core {
namespace {

using Vec2 = Eigen::Vector2d;

/// Point on the rim of the core: east side for t in [-1, 1], before rotation.
Vec2 core_rim(const Butterfly& p, double t)
{
    const double half_diagonal = p.core_fraction * p.diameter / 2;
    const Vec2 straight = half_diagonal / std::numbers::sqrt2 * Vec2(1, t);
    const double angle = std::numbers::pi / 4 * t;
    const Vec2 arc = half_diagonal * Vec2(std::cos(angle), std::sin(angle));
    return (1 - p.core_bulge) * straight + p.core_bulge * arc;
}

Vec2 turned(const Vec2& x, int quarters)
{
    switch (quarters % 4) {
    case 0: return x;
    case 1: return {-x.y(), x.x()};
    case 2: return -x;
    default: return {x.y(), -x.x()};
    }
}

/// Transfinite interpolation between the four rims of the core; (s, t) in [-1, 1]^2.
Vec2 core_point(const Butterfly& p, double s, double t)
{
    const Vec2 east = core_rim(p, t), west = turned(core_rim(p, -t), 2);
    const Vec2 north = turned(core_rim(p, -s), 1), south = turned(core_rim(p, s), 3);
    const double a = (1 + s) / 2, b = (1 + t) / 2;
    const Vec2 corner = core_rim(p, 1);
    const Vec2 ne = corner, nw(-corner.x(), corner.y()), sw = -corner, se(corner.x(), -corner.y());
    return a * east + (1 - a) * west + b * north + (1 - b) * south -
           (a * b * ne + (1 - a) * b * nw + (1 - a) * (1 - b) * sw + a * (1 - b) * se);
}

Vec2 wing_point(const Butterfly& p, int quarter, double t, int n)
{
    const double share = graded(n, p.wing_cells, p.wall_growth), angle = std::numbers::pi / 4 * t;
    const Vec2 wall = p.diameter / 2 * Vec2(std::cos(angle), std::sin(angle));
    return turned((1 - share) * core_rim(p, t) + share * wall, quarter);
}

} // namespace

double graded(int n, int cells, double growth)
{
    if (cells == 1 || std::abs(growth - 1) < 1e-12) return double(n) / cells;
    const double ratio = std::pow(1 / growth, 1.0 / (cells - 1));
    return (1 - std::pow(ratio, n)) / (1 - std::pow(ratio, cells));
}

std::array<int, 2> butterfly_cells(const Butterfly& section, int part)
{
    return {part == 0 ? section.core_cells : section.wing_cells, section.core_cells};
}

Eigen::Vector2d butterfly_point(const Butterfly& section, int part, int j, int k)
{
    const auto parameter = [&](int n) { return 2.0 * n / section.core_cells - 1; };
    return part == 0 ? core_point(section, parameter(j), parameter(k)) : wing_point(section, part - 1, parameter(k), j);
}

void check(const Butterfly& section)
{
    require<ConfigError>(section.diameter > 0, "a pipe needs a positive diameter");
    require<ConfigError>(section.core_cells > 0 && section.wing_cells > 0, "a pipe needs at least one cell in core and wings");
    require<ConfigError>(section.core_fraction > 0.1 && section.core_fraction < 0.9, "the core of a pipe takes 0.1 to 0.9 of its radius");
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/pipe.hpp"
#include "core/base/error.hpp"
#include <cmath>
#include <numbers>

namespace core {
namespace {

using Vec2 = Eigen::Vector2d;

/// Point on the rim of the core: east side for t in [-1, 1], before rotation.
Vec2 core_rim(const Pipe& p, double t)
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
Vec2 core_point(const Pipe& p, double s, double t)
{
    const Vec2 east = core_rim(p, t), west = turned(core_rim(p, -t), 2);
    const Vec2 north = turned(core_rim(p, -s), 1), south = turned(core_rim(p, s), 3);
    const double a = (1 + s) / 2, b = (1 + t) / 2;
    const Vec2 corner = core_rim(p, 1);
    const Vec2 ne = corner, nw(-corner.x(), corner.y()), sw = -corner, se(corner.x(), -corner.y());
    return a * east + (1 - a) * west + b * north + (1 - b) * south - (a * b * ne + (1 - a) * b * nw + (1 - a) * (1 - b) * sw + a * (1 - b) * se);
}

/// Share of the way from core to wall after `n` of `cells` cells, sizes in geometric progression.
double graded(int n, int cells, double growth)
{
    if (cells == 1 || std::abs(growth - 1) < 1e-12) return double(n) / cells;
    const double ratio = std::pow(1 / growth, 1.0 / (cells - 1));
    return (1 - std::pow(ratio, n)) / (1 - std::pow(ratio, cells));
}

Vec2 wing_point(const Pipe& p, int quarter, double t, int n)
{
    const double share = graded(n, p.wing_cells, p.wall_growth), angle = std::numbers::pi / 4 * t;
    const Vec2 wall = p.diameter / 2 * Vec2(std::cos(angle), std::sin(angle));
    return turned((1 - share) * core_rim(p, t) + share * wall, quarter);
}

/// One block of all sections [first, first + cells] along x; section(j, k) gives (y, z).
template <class Section>
Vertices extrude(const Pipe& p, int block_along, int nj, int nk, Section section)
{
    const int ni = p.axial_cells / p.blocks_along;
    Vertices v({ni + 1, nj + 1, nk + 1}, 0, Vec3::Zero());
    for_each_cell(v.extents(), [&](int i, int j, int k) {
        const Vec2 yz = section(j, k);
        v(i, j, k) = Vec3(p.length * (block_along * ni + i) / p.axial_cells, yz.x(), yz.y());
    });
    return v;
}

void check(const Pipe& p)
{
    require<ConfigError>(p.diameter > 0 && p.length > 0, "a pipe needs a positive diameter and length");
    require<ConfigError>(p.core_cells > 0 && p.wing_cells > 0, "a pipe needs at least one cell in core and wings");
    require<ConfigError>(p.blocks_along > 0 && p.axial_cells > 0 && p.axial_cells % p.blocks_along == 0,
                         text("a pipe of ", p.axial_cells, " cells along its axis does not divide into ", p.blocks_along, " blocks"));
    require<ConfigError>(p.core_fraction > 0.1 && p.core_fraction < 0.9, "the core of a pipe takes 0.1 to 0.9 of its radius");
}

} // namespace

MultiBlock make_pipe(const Pipe& p)
{
    check(p);
    const auto parameter = [&](int n) { return 2.0 * n / p.core_cells - 1; };
    MultiBlock grid;
    for (int along = 0; along < p.blocks_along; ++along) {
        grid.blocks.push_back(extrude(p, along, p.core_cells, p.core_cells,
                                      [&](int j, int k) { return core_point(p, parameter(j), parameter(k)); }));
        for (int quarter = 0; quarter < 4; ++quarter)
            grid.blocks.push_back(extrude(p, along, p.wing_cells, p.core_cells,
                                          [&](int j, int k) { return wing_point(p, quarter, parameter(k), j); }));
    }
    if (p.periodic) grid.periods.push_back(p.length * Vec3::UnitX());
    grid.boundary_name = [](BlockId, Side s) {
        return std::string(s == Side::i_low ? "x_low" : s == Side::i_high ? "x_high" : "wall");
    };
    return grid;
}

} // namespace core

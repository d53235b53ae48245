// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whole grids that a turn carries onto themselves, and one sector of each whose ends are joined by that turn.
#include "core/grid/annulus.hpp"
#include "tests/support/fluid_run.hpp"

namespace test {

inline constexpr int sectors = 8;
inline constexpr double sector_angle = 2 * std::numbers::pi / sectors;

/// From sector 0 to sector n, about x.
inline Vec3 turned(const Vec3& v, double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitX()) * v; }

/// Radii 0.5 and 1, length 1.
/// @param cells, blocks  Of one sector.
inline core::Annulus ring_shape(core::Extents cells, core::Extents blocks)
{
    core::Annulus shape;
    shape.inner_diameter = 1;
    shape.outer_diameter = 2;
    shape.length = 1;
    shape.cells = cells;
    shape.blocks = blocks;
    shape.periodic = true;
    return shape;
}

/// One eighth of a ring.
inline core::MultiBlock ring_sector(core::Extents cells, core::Extents blocks = {1, 1, 1})
{
    core::Annulus shape = ring_shape(cells, blocks);
    shape.angle = sector_angle;
    core::MultiBlock grid = core::make_annulus(shape);
    grid.turn = core::PeriodicTurn{Vec3::UnitX(), Vec3::Zero(), sector_angle};
    return grid;
}

/// The whole ring, one block for each sector.
inline core::MultiBlock whole_ring(core::Extents cells)
{
    cells.nk *= sectors;
    return core::make_annulus(ring_shape(cells, {1, 1, sectors}));
}

/// Distance from the axis.
inline double radius(const Vec3& x) { return std::hypot(x.y(), x.z()); }

/// A vector of components along the axis, outwards and around.
inline Vec3 cylindrical(const Vec3& x, double along, double outwards, double around)
{
    const Vec3 out = Vec3(0, x.y(), x.z()) / radius(x);
    return along * Vec3::UnitX() + outwards * out + around * Vec3::UnitX().cross(out);
}

/// Flow between cylinders of which the inner one turns at 1 rad/s, and waves that repeat in each sector.
inline Vec3 wavy_swirl(const Vec3& x)
{
    const double r = radius(x), angle = sectors * std::atan2(x.z(), x.y()), k = 2 * std::numbers::pi * x.x();
    const double between = std::sin(2 * std::numbers::pi * (r - 0.5));
    return cylindrical(x, 0.3 * between * std::sin(angle + 0.5), 0.2 * between * std::cos(angle) * std::cos(k),
                       (1 / r - r) / 3 + 0.2 * between * std::sin(angle) * std::sin(k));
}

/// A liquid between the cylinders.
inline physics::FluidParameters between_cylinders(double viscosity, physics::AdvectionScheme scheme)
{
    physics::FluidParameters liquid;
    liquid.viscosity = viscosity;
    liquid.advection = scheme;
    liquid.boundaries["inner"].profile = [](const Vec3& x) { return Vec3::UnitX().cross(x); };
    liquid.tolerances.pressure = liquid.tolerances.viscosity = 1e-13;
    liquid.tolerances.pressure_change = 1e-12;
    return liquid;
}

} // namespace test

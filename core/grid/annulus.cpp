// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/annulus.hpp"
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/butterfly.hpp"
#include <numbers>

namespace core {

MultiBlock make_annulus(const Annulus& a)
{
    require<ConfigError>(a.inner_diameter > 0 && a.outer_diameter > a.inner_diameter && a.length > 0,
                         "an annulus needs a length and an outer diameter larger than the inner one");
    constexpr double whole = 2 * std::numbers::pi;
    const double angle = a.angle.value_or(whole);
    require<ConfigError>(a.angle || a.cells.nk >= 3, "an annulus needs at least three cells around");
    require<ConfigError>(angle > 0 && (!a.angle || angle < whole),
                         "a sector of an annulus has an angle between 0 and 360 degrees; leave it out for the whole");
    require<ConfigError>(angle < 0.5 * whole * a.cells.nk, "a cell of a sector takes less than 180 degrees: take more cells around");
    Box index_box;
    index_box.high = {double(a.cells.ni), double(a.cells.nj), double(a.cells.nk)};
    index_box.cells = a.cells;
    index_box.blocks = a.blocks;
    const auto place = [&](const Vec3& index) {
        const double share = graded(int(std::lround(index.y())), a.cells.nj, 1 / a.growth);
        const double radius = 0.5 * (a.inner_diameter + share * (a.outer_diameter - a.inner_diameter));
        const auto line = std::lround(index.z());
        const auto around = double(a.angle ? line : line % a.cells.nk); // the seam of a whole one has one angle on both its sides
        const double at = angle * around / a.cells.nk;
        return Vec3(a.length * index.x() / a.cells.ni, radius * std::cos(at), radius * std::sin(at));
    };
    MultiBlock grid = make_box(index_box, place);
    if (a.periodic) grid.periods.push_back(a.length * Vec3::UnitX());
    grid.boundary_name = [](BlockId, Side s) {
        if (axis_of(s) == 0) return std::string(is_high(s) ? "x_high" : "x_low");
        if (axis_of(s) == 2) return std::string(is_high(s) ? "angle_high" : "angle_low");
        return std::string(is_high(s) ? "outer" : "inner");
    };
    return grid;
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A bent channel of cells that are much longer than high, cut into blocks in any way.
#include "core/grid/box.hpp"
#include "tests/support/conduction_boxes.hpp"
#include "tests/support/counted_otherwise.hpp"
#include <numbers>

namespace test {

struct StretchedChannel {
    core::Extents cells, blocks;
    double aspect;                 ///< length over height, of all cells or of those at the walls
    bool narrows = false;          ///< cells narrow towards the walls
    bool turned = false;           ///< blocks count their cells in different orders
    bool closed_in_itself = false; ///< what leaves at the top comes back at the bottom: no line has an end
};

/// Of height 1, bent to waves of a tenth of it: no block is straight.
[[nodiscard]] inline core::MultiBlock stretched_channel(const StretchedChannel& c)
{
    using core::Vec3;
    const auto y = c.narrows ? between_walls(c.cells.nj, 3.0 / c.cells.ni / c.aspect) : uniform(c.cells.nj, 1.0);
    const double length = c.narrows ? 3.0 : c.cells.ni * c.aspect / c.cells.nj;
    const Vec3 end(length, c.cells.nj, length * c.cells.nk / c.cells.ni);
    const core::Box box{{0, 0, 0}, end, c.cells, c.blocks, {false, c.closed_in_itself, false}};
    auto grid = core::make_box(box, [=](const Vec3& x) {
        const double height = y[std::size_t(std::lround(x.y()))];
        const double turn = 2 * std::numbers::pi * (x.x() / length + (c.closed_in_itself ? 0 : height));
        return Vec3(x.x(), height + 0.1 * std::sin(turn), x.z());
    });
    if (c.closed_in_itself) grid.periods = {Vec3(0, 1, 0)};
    if (c.turned) {
        for (std::size_t b = 0; b < grid.blocks.size(); ++b)
            for (std::size_t times = 0; times < b % 3; ++times) grid.blocks[b] = counted_otherwise(grid.blocks[b]);
        grid.boundary_name = [](core::BlockId, core::Side) { return std::string("wall"); };
    }
    return grid;
}

} // namespace test

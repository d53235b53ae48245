// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Cells that no solver can use are refused with block, side and cell, also where all their volumes are positive (NUMERICS D 29, D 30).
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/mesh.hpp"
#include "tests/support/relative.hpp"
#include <cmath>
#include <doctest/doctest.h>

namespace {

using core::Vec3;

/// Two blocks of 4 x 4 x 4 cells side by side.
core::MultiBlock two_blocks() { return core::make_box({{0, 0, 0}, {2, 1, 1}, {8, 4, 4}, {2, 1, 1}, {}}); }

void check_refused(core::MultiBlock grid, const char* text)
{
    CHECK_THROWS_WITH_AS(core::Mesh(std::move(grid), 0, 1), doctest::Contains(text), core::ConfigError);
}

} // namespace

TEST_CASE("one corner turned inside out is enough, though the cell has a positive volume")
{
    core::MultiBlock grid = two_blocks();
    core::Vertices& v = grid.blocks[1];
    v(4, 4, 4) = v(3, 3, 3) + Vec3(0.3 * (v(4, 4, 4) - v(3, 3, 3))); // within the plane of its three neighbours
    CHECK(core::cell_shape(v, {3, 3, 3}).volume > 0.2 * core::cell_shape(v, {0, 0, 0}).volume);
    check_refused(grid, "cell (3, 3, 3) of block 1 is folded or flat: its smallest corner Jacobian is -");
}

TEST_CASE("cells without thickness are refused, with the direction in which they have none")
{
    core::MultiBlock grid = two_blocks();
    auto& v = grid.blocks[0];
    for (int k = 0; k <= 4; ++k)
        for (int i = 0; i <= 4; ++i) v(i, 2, k) = v(i, 1, k);
    check_refused(grid, "cell (0, 1, 0) of block 0 has an edge of no length along j");
}

TEST_CASE("a side that is collapsed to a line is named")
{
    // The axis of a pipe as the low side of wedges.
    const auto wedge = [](const Vec3& x) { return Vec3(x.x() * std::cos(x.y()), x.x() * std::sin(x.y()), x.z()); };
    check_refused(core::make_box({{0, 0, 0}, {1, 1, 1}, {4, 4, 4}, {1, 1, 1}, {}}, wedge),
                  "cell (0, 0, 0) of block 0 has an edge of no length along j: side i_low is collapsed");
    const auto from_the_rim = [&](const Vec3& x) { return wedge(Vec3(-x.x(), -x.y(), x.z())); };
    check_refused(core::make_box({{-1, 0, 0}, {0, 1, 1}, {4, 4, 4}, {1, 1, 1}, {}}, from_the_rim), "side i_high is collapsed");
}

TEST_CASE("cells that are no numbers are refused")
{
    core::MultiBlock grid = two_blocks();
    grid.blocks[1](2, 3, 1) = Vec3(std::nan(""), 0, 0);
    check_refused(grid, "cell (1, 2, 0) of block 1 has a corner whose place is no number");
}

TEST_CASE("flat cells at the limit of what is refused pass: a thousand times a thousand as long as high")
{
    CHECK(core::Mesh(core::make_box({{0, 0, 0}, {1e6, 1, 1e6}, {2, 2, 2}, {1, 1, 1}, {}}), 0, 1).total_volume() == test::relative(1e12));
}

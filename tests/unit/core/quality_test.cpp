// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/grid/box.hpp"
#include "core/grid/mesh.hpp"
#include "core/grid/quality.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

using core::Index3, core::MultiBlock, core::Vec3;

namespace {

core::GridQuality quality(MultiBlock grid)
{
    const core::Topology topology = core::match_sides(grid);
    return core::quality_of(grid.blocks, topology);
}

core::Box box(core::Extents cells, core::Extents blocks) { return {{0, 0, 0}, {1, 1, 1}, cells, blocks, {false, false, false}}; }

std::string refusal(MultiBlock grid)
{
    try {
        const core::Mesh mesh(std::move(grid), 0, 1);
    } catch (const core::ConfigError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("bricks are perfect and have their aspect ratio")
{
    const auto q = quality(core::make_box(box({4, 2, 1}, {2, 1, 1})));
    CHECK(q.jacobian.value == test::relative(1).epsilon(1e-15));
    CHECK(std::abs(q.skewness.value) < 1e-15);
    CHECK(q.aspect_ratio.value == test::relative(4).epsilon(1e-15));
    CHECK(q.growth.value == test::relative(1).epsilon(1e-15));
}

TEST_CASE("a sheared box is skewed by the angle of the shear")
{
    const double angle = 75 * std::numbers::pi / 180;
    const auto q = quality(
        core::make_box(box({3, 3, 3}, {1, 1, 1}), [&](const Vec3& x) { return Vec3(x.x() + std::tan(angle) * x.y(), x.y(), x.z()); }));
    CHECK(q.skewness.value == test::relative(angle).epsilon(1e-13));
    CHECK(q.jacobian.value == test::relative(std::cos(angle)).epsilon(1e-12));
}

TEST_CASE("the worst growth is found across the side of two blocks, with block and cell")
{
    // Cells of 0.25 below x = 0.5, of 0.05 above: the jump by 5 lies between the blocks.
    const auto q = quality(core::make_box(
        box({4, 1, 1}, {2, 1, 1}), [](const Vec3& x) { return Vec3(x.x() < 0.51 ? x.x() : 0.5 + 0.2 * (x.x() - 0.5), x.y(), x.z()); }));
    CHECK(q.growth.value == test::relative(5).epsilon(1e-12));
    CHECK(q.growth.block == 0);
    CHECK(q.growth.cell == Index3{1, 0, 0});
}

TEST_CASE("folded, left-handed and collapsed cells are refused with block, cell and side")
{
    MultiBlock folded = core::make_box(box({4, 4, 4}, {2, 1, 1}));
    std::swap(folded.blocks[1](1, 2, 2), folded.blocks[1](0, 2, 2));
    CHECK(refusal(folded).find("of block 1 is folded or flat") != std::string::npos);
    CHECK(refusal(core::make_box(box({2, 2, 2}, {1, 1, 1}), [](const Vec3& x) {
              return Vec3(x.x(), x.y(), -x.z());
          })).starts_with("block 0 is left-handed"));
    // A polar grid down to its axis: side j_low is a line.
    const auto polar = core::make_box(box({2, 3, 4}, {1, 1, 1}),
                                      [](const Vec3& x) { return Vec3(x.x(), x.y() * std::cos(x.z()), x.y() * std::sin(x.z())); });
    CHECK(refusal(polar).starts_with("cell (0, 0, 0) of block 0 has an edge of no length along k: side j_low is collapsed"));
}

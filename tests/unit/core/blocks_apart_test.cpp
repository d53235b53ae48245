// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/grid/annulus.hpp"
#include "core/grid/blocks_apart.hpp"
#include "core/grid/pipe.hpp"
#include <doctest/doctest.h>

namespace {

core::Vertices box(const core::Vec3& low, const core::Vec3& high, int cells)
{
    core::Vertices v({cells + 1, cells + 1, cells + 1}, 0, core::Vec3::Zero());
    core::for_each_cell(v.extents(), [&](int i, int j, int k) { v(i, j, k) = low + core::Vec3(i, j, k).cwiseProduct(high - low) / cells; });
    return v;
}

core::MultiBlock two(const core::Vertices& a, const core::Vertices& b)
{
    core::MultiBlock grid;
    grid.blocks = {a, b};
    return grid;
}

} // namespace

TEST_CASE("blocks that touch are apart, whether their points match or not")
{
    CHECK_NOTHROW(core::require_apart(two(box({0, 0, 0}, {1, 1, 1}, 4), box({1, 0, 0}, {2, 1, 1}, 4))));
    CHECK_NOTHROW(core::require_apart(two(box({0, 0, 0}, {1, 1, 1}, 4), box({1, 0.3, 0.1}, {2, 1.5, 0.7}, 7))));
    CHECK_NOTHROW(core::require_apart(core::make_pipe({})));
    CHECK_NOTHROW(core::require_apart(core::make_annulus({})));
}

TEST_CASE("blocks that lie in one another are named, whichever is finer")
{
    const auto a = box({0, 0, 0}, {1, 1, 1}, 4), across = box({0.6, 0.2, 0.3}, {1.6, 1.2, 1.3}, 3),
               within = box({0.41, 0.42, 0.43}, {0.6, 0.6, 0.6}, 2);
    for (const auto& [first, second] :
         {std::pair(a, across), std::pair(across, a), std::pair(a, within), std::pair(within, a), std::pair(a, a)})
        CHECK_THROWS_WITH_AS(core::require_apart(two(first, second)), doctest::Contains("blocks 0 and 1 overlap: cell ("),
                             core::ConfigError);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The twelve edges of a cell.
#include "core/grid/multi_block.hpp"

namespace core {

/// Calls body(axis, low end, high end) for the twelve edges of a cell.
template <class Body>
void for_each_edge(Index3 c, Body body)
{
    for (int axis = 0; axis < 3; ++axis)
        for_each({0, 0, 0}, {axis == 0 ? 1 : 2, axis == 1 ? 1 : 2, axis == 2 ? 1 : 2}, [&](int i, int j, int k) {
            const Index3 low{c.i + i, c.j + j, c.k + k};
            Index3 high = low;
            ++high[axis];
            body(axis, low, high);
        });
}

/// Mean edge of a cell along each axis [m].
[[nodiscard]] inline Vec3 mean_edges(const Vertices& v, Index3 c)
{
    Vec3 sum = Vec3::Zero();
    for_each_edge(c, [&](int axis, Index3 low, Index3 high) { sum[axis] += (v.view()[high] - v.view()[low]).norm(); });
    return sum / 4;
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/transfinite.hpp"

namespace core {
namespace {

/// The value at `c` interpolated linearly along the axes of `axes` between the sides there.
Vec3 between_sides(const Vertices& v, Index3 c, unsigned axes)
{
    Vec3 sum = Vec3::Zero();
    for (unsigned ends = 0; ends < 8; ++ends) {
        if ((ends & ~axes) != 0) continue;
        Index3 at = c;
        double weight = 1;
        for (int m = 0; m < 3; ++m) {
            if ((axes >> m & 1U) == 0) continue;
            const int last = v.extents()[m] - 1;
            const double share = double(c[m]) / last;
            const bool high = (ends >> m & 1U) != 0;
            weight *= high ? share : 1 - share;
            at[m] = high ? last : 0;
        }
        sum += weight * v.view()[at];
    }
    return sum;
}

} // namespace

void fill_transfinite(Vertices& block)
{
    const Extents n = block.extents();
    for_each({1, 1, 1}, {n.ni - 1, n.nj - 1, n.nk - 1}, [&](int i, int j, int k) {
        const Index3 c{i, j, k};
        const Vec3 faces = between_sides(block, c, 1) + between_sides(block, c, 2) + between_sides(block, c, 4);
        const Vec3 edges = between_sides(block, c, 3) + between_sides(block, c, 5) + between_sides(block, c, 6);
        block(i, j, k) = faces - edges + between_sides(block, c, 7);
    });
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/boundary_paths.hpp"
#include "physics/fluid/side_faces.hpp"

namespace physics {

void end_at_boundaries(const BlockWalls& walls, core::VectorView<double> displacement)
{
    constexpr double to_boundary = 0.5; // cells, from the centre of the cell beside it
    for (const core::Side side : core::all_sides) {
        if (!walls.at(side).kind) continue;
        const int axis = core::axis_of(side);
        const double inward = core::is_high(side) ? -1.0 : 1.0;
        const auto along = displacement.component(axis);
        for_each_side_face(along.extents(), side, [&](int i, int j, int k) {
            const core::Index3 c = cell_at_face({i, j, k}, side);
            const double way = inward * along[c];
            if (way <= to_boundary) return;
            for (int m = 0; m < 3; ++m) displacement.component(m)[c] *= to_boundary / way;
        });
    }
}

} // namespace physics

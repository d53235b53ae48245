// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/wall_shear.hpp"
#include "physics/fluid/wall_cells.hpp"

namespace physics {

double largest_wall_shear(const core::BlockGeometry& geometry, const BlockWalls& walls, core::VectorView<const double> velocity)
{
    double largest = 0;
    for (const WallCell& at : wall_cells(geometry, walls)) largest = std::max(largest, slip_speed(walls, at, velocity) / at.distance);
    return largest;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The cells of a block that lie beside walls which hold the fluid.
#include "physics/fluid/boundary.hpp"

namespace physics {

struct WallCell {
    core::Index3 cell, face; ///< the face in the indices of the FaceView along the side's axis
    core::Side side;
    double distance;   ///< from the cell's centre to the wall [m]
    core::Vec3 normal; ///< of unit length
    double share;      ///< 1 over the number of walls beside the cell
};

/// In the order of sides and faces.
[[nodiscard]] std::vector<WallCell> wall_cells(const core::BlockGeometry& geometry, const BlockWalls& walls);

/// Speed along the wall, relative to it [m/s].
[[nodiscard]] double slip_speed(const BlockWalls& walls, const WallCell& at, core::VectorView<const double> velocity);

} // namespace physics

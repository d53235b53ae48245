// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How fast the flow shears beside walls, which is what turbulence there lives by.
#include "physics/fluid/boundary.hpp"

namespace physics {

/// The largest of the cells beside walls that hold the fluid; of a wall that is resolved, the square of the friction speed over the
/// viscosity [1/s].
[[nodiscard]] double largest_wall_shear(const core::BlockGeometry& geometry, const BlockWalls& walls,
                                        core::VectorView<const double> velocity);

} // namespace physics

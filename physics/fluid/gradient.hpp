// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Least-squares gradients in the cells of a block.
#include "core/grid/geometry.hpp"

namespace physics {

/// Cartesian gradient of a cell field; exact for linear fields.
/// @param matrices  geometry.gradient for a field mirrored evenly beyond walls, geometry.wall_gradient for one mirrored
///                  oddly about its value on the wall (see boundary_halo.hpp): both need no case for walls.
/// @param q         One halo layer, straight beyond the sides.
/// @param[out] out  Interior [unit of q / m].
void gradient(const core::BlockGeometry& geometry, const core::GradientMatrices& matrices, core::View<const double> q,
              core::VectorView<double> out);

/// Curl of a velocity from the gradients of its components.
/// @param[out] curl  Interior [1/s].
void vorticity(core::VectorView<const double> gradient_x, core::VectorView<const double> gradient_y,
               core::VectorView<const double> gradient_z, core::VectorView<double> curl);

} // namespace physics

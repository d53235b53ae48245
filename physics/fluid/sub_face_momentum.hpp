// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finite-volume advection of momentum through the sub-faces between blocks whose points do not match: one flux of it through each, the
// same for both blocks to the last bit, of the velocity in the middle of the step at the centre of the sub-face.
#include "core/grid/geometry.hpp"

namespace physics {

/// Nothing goes through whole faces on joined sides.
void close_joined(const core::BlockGeometry& geometry, core::FaceView<double> flux);

/// What flows through the sub-faces in a step changes the cells beside them.
/// @param flux      In the middle of the step [m3/s].
/// @param middle    With its values at the centres of sub-faces [m/s].
/// @param velocity  Interior, updated [m/s].
void carry_through_sub_faces(const core::BlockGeometry& geometry, double dt, core::FaceView<const double> flux,
                             core::VectorView<const double> middle, core::VectorView<double> velocity);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finite-volume advection of momentum through the sub-faces between blocks whose points do not match: one flux of it through each, the
// same for both blocks to the last bit. With u the velocity of the middle of the step at the centre of a sub-face of area S,
//     flux of momentum = S . (u + (m_a + m_b) / 2) u,
// where m of the cells on both sides is what the fluxes through their faces, free of divergence, have beyond those of u: zero in a
// uniform flow, of second order elsewhere.
#include "core/grid/geometry.hpp"

namespace physics {

/// m, along the area of the faces: those of the joined sides of a cell added up.
/// @param flux        Through whole faces [m3/s].
/// @param middle      With its values at the centres of sub-faces [m/s].
/// @param[out] miss   Cells beside sub-faces; others are left as they are [m/s].
void flux_beyond_interpolated(const core::BlockGeometry& geometry, core::FaceView<const double> flux, core::VectorView<const double> middle,
                              core::VectorView<double> miss);

/// Nothing goes through whole faces on joined sides.
void close_joined(const core::BlockGeometry& geometry, core::FaceView<double> flux);

/// What flows through the sub-faces in a step changes the cells beside them.
/// @param miss      With its values of the cells beyond.
/// @param velocity  Interior, updated [m/s].
void carry_through_sub_faces(const core::BlockGeometry& geometry, double dt, core::VectorView<const double> middle,
                             core::VectorView<const double> miss, core::VectorView<double> velocity);

} // namespace physics

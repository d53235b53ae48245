// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Keeps advected vectors within the range of what surrounds their departure points. Interpolation that overshoots feeds energy to
// waves of two to four cells, and where viscosity is too small to damp them a flow gains speed without end. The price: crests of
// smooth waves are cut, which leaves second order there instead of third.
//
// The components in index space, along the grid lines of the cell, are clipped to those of the eight cells around the departure point:
// what comes out turns with the scene, and does not depend on how blocks count. Cartesian components would depend on both.
#include "core/grid/geometry.hpp"

namespace physics {

/// @param q             What was advected, one halo layer.
/// @param displacement  At most one cell in each direction.
/// @param advected      Interior: kept in the range of the eight cells of q around each departure point.
/// @source  Bermejo & Staniforth (1992), quasi-monotone semi-Lagrangian schemes.
void keep_in_range(const core::BlockGeometry& geometry, core::VectorView<const double> q, core::VectorView<const double> displacement,
                   core::VectorView<double> advected);

} // namespace physics

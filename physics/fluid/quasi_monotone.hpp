// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Keeps advected values within the range of what surrounds their departure points. Interpolation that overshoots feeds energy to
// waves of two to four cells, and where viscosity is too small to damp them a flow gains speed without end. The price: crests of
// smooth waves are cut, which leaves second order there instead of third.
#include "core/field/field.hpp"

namespace physics {

/// @param q             What was advected, one halo layer.
/// @param displacement  At most one cell in each direction.
/// @param advected      Interior: clipped to the eight cells of q around each departure point.
/// @source  Bermejo & Staniforth (1992), quasi-monotone semi-Lagrangian schemes.
void keep_in_range(core::VectorView<const double> q, core::VectorView<const double> displacement, core::VectorView<double> advected);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The schemes by which a flow carries its own velocity.

namespace physics {

enum class AdvectionScheme {
    lcsi,         ///< from departure points, by six-point Hermite interpolation kept within the range of the neighbours
    lcsi_spline,  ///< the same by local cubic splines, not kept within any range: for comparison
    finite_volume ///< by fluxes through faces: momentum is kept to round-off
};

} // namespace physics

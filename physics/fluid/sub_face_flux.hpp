// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fluxes through the sub-faces on sides of blocks whose points do not match, summed up to the faces of the block. Both blocks
// find the same flux of each sub-face to the last bit. Blocks without such sides return at once.
#include "core/grid/geometry.hpp"

namespace physics {

/// Flux of grad q, F = T (q_b - q_a) + (S - T d) . (g_a + g_b) / 2 of each sub-face, as face_flux.hpp has it of faces.
/// @param q          One halo layer, and what lies behind the halo.
/// @param gradients  Of q, the same.
/// @param flux       Values on faces of joined sides are overwritten.
void sub_face_gradient_flux(const core::BlockGeometry& geometry, core::View<const double> q, core::VectorView<const double> gradients,
                            core::FaceView<double> flux);

/// Flux of a vector, interpolated to the centre of each sub-face.
void sub_face_interpolated_flux(const core::BlockGeometry& geometry, core::VectorView<const double> u, core::FaceView<double> flux);

/// How much a pressure gradient makes of a volume flux, for add_pressure_smoothing() of projection.hpp.
struct SmoothingStrength {
    double mobility;  ///< dt / density [m3 s/kg]
    double diffusion; ///< of the implicit viscosity [m2]
};

/// Sets aside the flux through joined sides, before a loop over all faces spoils it.
void set_joined_aside(const core::BlockGeometry& geometry, core::FaceView<double> scratch, core::FaceView<const double> flux);
/// flux = what was set aside, with mobility (S . (g_a + g_b) / 2 - F) of each sub-face added, F the compact flux of the pressure.
void smooth_joined_pressure(const core::BlockGeometry& geometry, const SmoothingStrength& strength, core::View<const double> pressure,
                            core::VectorView<const double> gradient, core::FaceView<const double> aside, core::FaceView<double> flux);

} // namespace physics

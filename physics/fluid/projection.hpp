// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From a predicted velocity to one free of divergence: fluxes through faces that feel the compact pressure gradient, and
// their correction. All for an impulse psi = mobility * pressure; without particles the mobility is dt / density.
#include "physics/fluid/face_flux.hpp"

namespace physics {

/// What the pressure gradient of a predicted velocity does to faces (Rhie-Chow): takes out the gradient interpolated from
/// the cells and puts in the compact one, which sees a checkerboard.
/// @param mobility   dt / density [m3 s/kg].
/// @param diffusion  Of the implicit viscosity, share * dt * viscosity [m2]: it damps what the pressure does to the
///                   velocity from cell to cell, and must do the same here, or stiff viscosity makes the pressure grow.
/// @param scratch    Overwritten.
void add_pressure_smoothing(const core::BlockGeometry& geometry, const BlockWalls& walls, double mobility, double diffusion,
                            core::View<const double> pressure, core::VectorView<const double> pressure_gradient,
                            core::FaceView<double> scratch, core::FaceView<double> flux);

/// flux -= compact flux of grad psi, the same that the pressure operator balances.
/// @param scratch  Overwritten by the compact flux.
void correct_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> psi,
                  core::VectorView<const double> psi_gradient, core::FaceView<double> scratch, core::FaceView<double> flux);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the fluxes through faces know and the velocities of the cells do not: that part of the pressure gradient which
// interpolation from the cells cannot see. A step that follows longer ones keeps it, or its projection would have to make it
// up anew, with a pressure like 1 / dt (NUMERICS B1 iv, D33).
//
// With I the interpolation from cells to faces, I* its adjoint, G the compact gradient on faces and I* G that in the cells:
//     flux = I u + d,     d' = (1 - dt / t) d - (dt / rho) A G p,     A = 1 - I I*,     t the memory time, dt <= t.
// Steps as long as t remember nothing and give d as one projection does; shorter ones approach the same d over the time t:
// the damping of pressure by faces does not depend on the step. It feeds no energy: with E = |u|^2 / 2 + d . A^-1 d / 2 and
// w the velocity before the pressure, a step changes E, as flux is free of divergence and so normal to G p, to
//     E' = |w|^2 / 2 + (1 - dt / t)^2 d . A^-1 d / 2 - |u' - w|^2 / 2 - (d' - (1 - dt / t) d) . A^-1 (d' - (1 - dt / t) d) / 2,
// which is at most |w|^2 / 2 + d . A^-1 d / 2. Keeping all of d for ever (t infinite) would let d grow without bound, and
// velocities that are far from free of divergence gain energy by their own advection.
#include "physics/fluid/face_flux.hpp"

namespace physics {

/// Splits what the last step left on faces.
/// @param flux               Of the last step [m3/s].
/// @param velocity           Of the same time, one halo layer: what `flux` is compared with [m/s].
/// @param[out] remembered    flux - interpolated velocity; zero on walls.
/// @param[out] outflow       Net outflow of `flux`: what its projection left.
void split_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::FaceView<const double> flux,
                core::VectorView<const double> velocity, core::FaceView<double> remembered, core::View<double> outflow);

/// flux += share * remembered; nothing if the share is zero, and what is remembered then need not be there.
void add_remembered(double share, core::FaceView<const double> remembered, core::FaceView<double> flux);

/// Takes off the net outflow what the last projection left, or every step would have to remove it at once.
void take_off_remembered(double share, core::View<const double> remembered, core::View<double> outflow);

} // namespace physics

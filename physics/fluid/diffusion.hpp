// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Viscosity: the Laplacian of each velocity component, explicit and as part of an implicit operator.
#include "physics/fluid/face_flux.hpp"

namespace physics {

/// Factors on faces; none: 1 everywhere.
using FaceFactors = std::optional<core::FaceView<const double>>;

/// Net flux of grad q into each cell, walls included.
struct DiffusiveInflow {
    core::FaceView<double> flux; ///< scratch
    core::View<double> inflow;   ///< out; interior [unit of q m]
};
void diffusive_inflow(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q,
                      core::VectorView<const double> gradients, const FaceFactors& factors, DiffusiveInflow out);

/// viscosity * Laplacian of q.
/// @param viscosity  Kinematic [m2/s].
/// @param inflow     Of diffusive_inflow(); may be the same as out.
/// @param[out] out   [unit of q / s].
void viscous_acceleration(const core::BlockGeometry& geometry, double viscosity, core::View<const double> inflow, core::View<double> out);

/// Sum of the transmissibilities of each cell's faces, walls included [m].
void transmissibility_sum(const core::BlockGeometry& geometry, core::View<double> sum);
/// The same times factors on the faces.
void transmissibility_sum(const core::BlockGeometry& geometry, core::FaceView<const double> factors, core::View<double> sum);
/// Multiplies a flux by the factors.
void scale_flux(const core::BlockGeometry& geometry, const FaceFactors& factors, core::FaceView<double> flux);

} // namespace physics

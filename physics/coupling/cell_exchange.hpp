// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The cells' side of the exchange on one block: predictor and mobility of the projection (steps 4 and 5 of
// response.hpp). Forces are per volume, without the drive unless said.
#include "physics/coupling/exchange_fields.hpp"
#include "physics/fluid/boundary.hpp"

namespace physics {

using CellVectors = core::VectorView<const double>;
using GrainSumViews = std::array<core::View<const double>, grain_sums>;

/// What a cell knows of the fluid before it meets the grains.
struct FluidOwn {
    CellVectors velocity;          ///< that the grains were told: u^n, or of the last pass [m/s]
    CellVectors advected;          ///< u^a: u^n advected and diffused [m/s]
    CellVectors pressure_gradient; ///< that the grains were told [Pa/m]
    core::Vec3 drive;              ///< mean acceleration [m/s2]
    double density;                ///< [kg/m3]
    double dt;                     ///< [s]
};

/// Volume flux density of the mixture, phi u + put(V v) [m/s].
/// @param velocity  Of the fluid [m/s].
void mixture_flux(CellVectors velocity, const GrainSumViews& sums, core::VectorView<double> flux);
/// Its inverse: the velocity of the fluid that makes a flux of the mixture what it is; both may be the same array.
void fluid_velocity(CellVectors flux, const GrainSumViews& sums, core::VectorView<double> velocity);

/// Flux density of the grains, put(V v) [m/s].
void flux_density_of_grains(const GrainSumViews& sums, core::VectorView<double> density);
/// The flux of grains through faces; nothing of it passes boundaries, which hold grains back [m3/s].
/// @param density  One halo layer.
void flux_of_grains(const core::BlockGeometry& geometry, const BlockWalls& walls, CellVectors density, core::FaceView<double> flux);

/// du of the predictor.
void predicted_velocity_change(const FluidOwn& own, const GrainSumViews& sums, CellVectors ledger, CellVectors miss,
                               core::VectorView<double> change);

/// Total volume flux density phi u* + solid flux*, and how much of it the known pressure gradient made per unit of force.
void predicted_volume_flux(const FluidOwn& own, const GrainSumViews& sums, CellVectors change, CellVectors miss,
                           core::View<double> known_mobility, core::VectorView<double> carried);

/// Coefficients of the projection.
void projection_response(const GrainSumViews& sums, double density, double dt, core::View<double> response, core::View<double> mobility);

/// How the fluid answered in a step.
struct FluidAnswer {
    CellVectors change;                ///< du of the predictor [m/s]
    core::View<const double> response; ///< ru of the projection [m3 s/kg]
    CellVectors gradient_change;       ///< of the pressure, -dG [Pa/m]
    CellVectors miss;                  ///< [m/s]
};

/// Ledger: what is left of the fluid's equation with the sums over the real grains in place of those it took.
/// @param own     With the new velocity.
/// @param ledger  In: what the step paid; out: what it leaves [N s/m3].
void unpaid_impulse(const FluidOwn& own, const GrainSumViews& sums, const FluidAnswer& answer, core::VectorView<double> ledger);

} // namespace physics

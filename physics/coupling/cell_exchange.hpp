// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The cells' side of the exchange on one block: predictor, mobility of the projection, correction, ledger (steps 4, 5 and
// 7 of response.hpp). Forces are per volume, without the drive unless said.
#include "physics/coupling/exchange_fields.hpp"

namespace physics {

using CellVectors = core::VectorView<const double>;
using GrainSumViews = std::array<core::View<const double>, grain_sums>;

/// The fluid's own change over the step: what the single-phase predictor found, split into known parts.
struct FluidOwn {
    CellVectors velocity;          ///< u^n [m/s]
    CellVectors predicted;         ///< u^n advected and diffused, plus dt (drive - grad p^n / rho) [m/s]
    CellVectors pressure_gradient; ///< of p^n [Pa/m]
    core::Vec3 drive;              ///< mean acceleration [m/s2]
    double density;                ///< [kg/m3]
    double dt;                     ///< [s]
};

/// u^a = predicted - dt (drive - grad p / rho); miss = u^n - u^a - dt Dudt.
void untold_change(const FluidOwn& own, CellVectors acceleration, core::VectorView<double> advected, core::VectorView<double> miss);

/// du of the predictor.
void predicted_velocity_change(const FluidOwn& own, const GrainSumViews& sums, CellVectors ledger, CellVectors miss,
                               core::VectorView<double> change);

/// Total volume flux density phi u* + solid flux*, and how much of it the known pressure gradient made per unit of force.
void predicted_volume_flux(const FluidOwn& own, const GrainSumViews& sums, CellVectors change, CellVectors miss,
                           core::View<double> known_mobility, core::VectorView<double> carried);

/// Coefficients of the projection.
void projection_response(const GrainSumViews& sums, double density, double dt, core::View<double> response, core::View<double> mobility);

/// Ledger of the advection, L = -rho (phi^{n+1} - phi^n + dt outflow / volume) u^a.
void advection_ledger_of(const core::BlockGeometry& geometry, core::View<const double> fraction, core::View<const double> fraction_before,
                         core::View<const double> fluid_outflow, const FluidOwn& own, CellVectors advected, core::VectorView<double> ledger);

} // namespace physics

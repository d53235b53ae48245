// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fluid velocity before the projection: implicit in what the grains were not told (step 4 of response.hpp).
#include "physics/coupling/response.hpp"

namespace physics {

/// What acts on the fluid of a cell over the step, one component, per volume.
struct FluidPush {
    double ledger = 0.0;            ///< L, impulse still owed to the fluid [N s/m3]
    double force = 0.0;             ///< G known to the grain lane [N/m3]
    double exchanged = 0.0;         ///< put(J), impulse the grains took [N s/m3]
    double velocity_used = 0.0;     ///< fluid velocity the grain lane used (u^n, or the last pass) [m/s]
    double velocity_advected = 0.0; ///< u^a [m/s]
    double miss = 0.0;              ///< velocity_used - u^a - dt Dudt_used: acceleration the grains were not told [m/s]
};

/// Impulse on the fluid of a cell before it changes its velocity from `velocity_used` [N s/m3].
/// @param sums  put() of the grains' responses with the yield of the predictor.
[[nodiscard]] inline double impulse_on_fluid(const FluidPush& push, double fluid_mass, double phi, const GrainResponse& sums, double dt)
{
    return push.ledger + dt * phi * push.force - push.exchanged + fluid_mass * (push.velocity_advected - push.velocity_used) -
           sums.added * push.miss;
}

/// Impulse that the grains took from the fluid of a cell, one component [N s/m3]: the drag of held grains is that of the fluid
/// there, although they feel the filtered velocity. Sums over all cells and all grains are equal all the same.
/// @param deposited  put(J - held drag B u), u the velocity that the grains were told [N s/m3].
/// @param held       put(held drag) (contact_share.hpp) [kg/m3].
/// @param velocity   u in the cell [m/s].
[[nodiscard]] inline double impulse_taken(double deposited, double held, double velocity) { return deposited + held * velocity; }

/// Change du of the fluid velocity from `velocity_used`.
/// @param sums  put() of the grains' responses with the yield of the predictor.
[[nodiscard]] inline double predicted_change(const FluidPush& push, double fluid_mass, double phi, const GrainResponse& sums, double dt)
{
    return impulse_on_fluid(push, fluid_mass, phi, sums, dt) / (fluid_mass + sums.reaction);
}

/// Solid volume flux that belongs to the predictor, beside put(V v).
[[nodiscard]] inline double predicted_solid_flux(double du, double miss, const GrainResponse& sums)
{
    return sums.flux * du + sums.added_flux * miss;
}

} // namespace physics

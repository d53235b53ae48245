// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the fluid gave beyond the impulse the grains received: owed to each grain in the next step (steps 6 and 7).
#include "physics/coupling/response.hpp"

namespace physics {

/// Cell fields of the finished step sampled at one grain, one component, at the positions n+1.
struct SampledChange {
    double force_used = 0.0;   ///< B G that the sub-steps used, at the old position [N/m3]
    double force_new = 0.0;    ///< B G^{n+1} [N/m3]
    double force_change = 0.0; ///< B dG [N/m3]
    double predictor = 0.0;    ///< B du of the predictor [m/s]
    double projection = 0.0;   ///< B (ru dG) [m/s]
    double miss = 0.0;         ///< B miss [m/s]
};

/// Impulse owed to a grain, to be delivered evenly over the next interval [N s].
/// @param predictor_response   response_to_velocity() with the yield of the predictor.
/// @param projection_response  response_to_pressure() with the yield of the projection.
[[nodiscard]] inline double owed_impulse(const SampledChange& at, double volume, const GrainResponse& predictor_response,
                                         const GrainResponse& projection_response, double dt)
{
    return volume * dt * (at.force_new - at.force_used) + predictor_response.reaction * at.predictor + predictor_response.added * at.miss +
           projection_response.reaction * at.projection - projection_response.flux * dt * at.force_change;
}

/// Ledger of any advection: what flux form would have kept, less what the new fluid mass carries at u^a [N s/m3].
/// @param kept        rho phi^n u^n - dt div(F rho u), the momentum of a conservative advection [N s/m3].
/// @param fluid_mass  rho phi^{n+1} [kg/m3].
[[nodiscard]] inline double conserved_ledger(double kept, double fluid_mass, double velocity_advected)
{
    return kept - fluid_mass * velocity_advected;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The cell fields through which grains and fluid exchange momentum (see response.hpp for the algorithm).
#include "core/field/batch.hpp"
#include "core/grid/mesh.hpp"
#include "physics/coupling/response.hpp"

namespace physics {

/// What grains deposit, per volume of cell and filtered: the arrays of a batch, in this order.
enum GrainSum : std::size_t {
    sum_solid,                          ///< C [-]
    sum_flux,                           ///< put(V v), three components [m/s]
    sum_impulse = sum_flux + 3,         ///< put(J), three components [N s/m3]
    sum_predictor = sum_impulse + 3,    ///< reaction, flux
    sum_projection = sum_predictor + 2, ///< reaction, flux, displaced
    sum_held = sum_projection + 3,      ///< held drag [kg/m3]
    sum_added = sum_held + 1,           ///< added, added_flux of the predictor: zero without added mass
    grain_sums = sum_added + 2
};

/// What grains sample: columns of their tables, and arrays of the batches that hold them one after the other.
enum GrainView : std::size_t {
    view_velocity,                               ///< u, filtered [m/s]
    view_pressure_force = view_velocity + 3,     ///< -grad p, filtered [N/m3]
    view_acceleration = view_pressure_force + 3, ///< Du/Dt, filtered [m/s2]
    state_views = view_acceleration + 3,
    view_stress = state_views, ///< div tau, filtered [N/m3]
    told_views = view_stress + 3,
    view_vorticity = told_views, ///< curl u, of the cells: no force acts back through it [1/s]
    grain_views = view_vorticity + 3
};

/// What grains sample of a model of turbulence.
enum SeenOfTurbulence : std::size_t {
    seen_deviation, ///< of each component of velocity; none at boundaries that nothing passes [m/s]
    seen_rate,      ///< at which fluctuations are forgotten [1/s]
    seen_growth,    ///< gradient of the deviation, three components [1/s]
    seen_of_turbulence = seen_growth + 3
};

/// What grains set against turbulence, per volume of cell (turbulence_damping.hpp).
enum ResistingTurbulence : std::size_t {
    resisting_drag, ///< sum of K [kg/(m3 s)]
    resisting_mass, ///< with added mass [kg/m3]
    resisting
};

/// What grains sample when the fluid has answered: the views of the new state, and
enum GrainNews : std::size_t {
    news_projection = state_views, ///< ru dG, filtered [m/s]
    news_views = news_projection + 3,
    news_stress = news_views, ///< of the new state: what the next step tells [N/m3]
    grain_news = news_stress + 3
};

struct ExchangeFields {
    explicit ExchangeFields(const core::Mesh& mesh)
        : fraction({"fluid fraction", "1", 1, true}, mesh.own_cells()),
          acceleration({"fluid acceleration", "m/s2", 1, true}, mesh.own_cells()),
          ledger({"ledger", "N s/m3", 0, true}, mesh.own_cells()),
          fraction_before({"fluid fraction before", "1", 0, false}, mesh.own_cells()),
          viscous({"viscous acceleration of the new velocity", "m/s2", 0, false}, mesh.own_cells()),
          sums({"sums over grains", "", 1, false}, mesh.own_cells()),
          assumed({"sums over assumed grains", "", 1, false}, mesh.own_cells()),
          told({"told state", "", 1, false}, mesh.own_cells()),
          vorticity({"vorticity for grains", "1/s", 1, false}, mesh.own_cells()),
          turbulence({"turbulence for grains", "", 1, false}, mesh.own_cells()),
          resistance({"resistance of grains to turbulence", "", 1, false}, mesh.own_cells()),
          surface({"surface of grains", "1/m", 1, false}, mesh.own_cells()),
          news({"answer for grains", "", 1, false}, mesh.own_cells()),
          advected({"advected velocity u^a", "m/s", 0, false}, mesh.own_cells()),
          miss({"untold change of velocity", "m/s", 0, false}, mesh.own_cells()),
          change({"predicted change of velocity", "m/s", 0, false}, mesh.own_cells()),
          response({"velocity per force", "m3 s/kg", 0, false}, mesh.own_cells()),
          mobility({"mobility", "m3 s/kg", 1, false}, mesh.own_cells()),
          known_mobility({"mobility of the known pressure", "m3 s/kg", 1, false}, mesh.own_cells()),
          carried({"volume flux density without pressure", "m/s", 1, false, true}, mesh.own_cells())
    {
    }

    core::ScalarField fraction;     ///< phi
    core::VectorField acceleration; ///< Du/Dt of the last step
    core::VectorField ledger;       ///< L: impulse that the fluid is still owed
    core::ScalarField fraction_before;
    // Of the velocity that a step ends with, for the next one: they follow from the state, so no checkpoint has them.
    core::VectorField viscous;
    core::FieldBatch<grain_sums> sums, assumed; ///< of the grains as they are, and as a fluid lane takes them that does not wait
    core::FieldBatch<told_views> told;          ///< filtered state that the grains are told
    core::FieldBatch<3> vorticity;
    core::FieldBatch<seen_of_turbulence> turbulence;
    core::FieldBatch<resisting> resistance;
    core::FieldBatch<1> surface; ///< put(V / d): C over the Sauter diameter of the grains around; of mixtures alone [1/m]
    core::FieldBatch<grain_news> news;
    core::VectorField advected; ///< u^a: advection and viscosity alone
    core::VectorField miss, change;
    core::ScalarField response, mobility, known_mobility;
    core::VectorField carried;
};

/// The response sums of a cell, read from the batch; the projection keeps its own reaction and flux.
template <class Views>
[[nodiscard]] GrainResponse predictor_sums(const Views& sums, int i, int j, int k)
{
    return {sums[sum_predictor](i, j, k), sums[sum_predictor + 1](i, j, k), 0.0, sums[sum_added](i, j, k), sums[sum_added + 1](i, j, k)};
}

template <class Views>
[[nodiscard]] GrainResponse projection_sums(const Views& sums, int i, int j, int k)
{
    return {sums[sum_projection](i, j, k), sums[sum_projection + 1](i, j, k), sums[sum_projection + 2](i, j, k), 0.0, 0.0};
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep before a step: the filter and the fluid fraction of a new state, and how stiff its coupling is.
#include "physics/coupling/drag.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/coupled_step.hpp"
#include <algorithm>

namespace physics {

using core::LocalBlock;

tasks::Job CoupledStep::find_fraction(tasks::Lane& lane)
{
    for (LaneFilter* filter : {&filter_, fluid_filter_.get()})
        if (filter) co_await set_up_on_mesh(lane, filter->own, mesh_, ranks_.rank());
    co_await sum_over_grains(lane, {dynamics_.particles, fields_.told, 0.0, places_.get(), holds_.get()}, filter_.own, fields_.sums);
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b)
        map_cells(
            fields_.fraction.on(b), [](double c) { return 1.0 - c; }, fields_.sums.on(b)[sum_solid]);
    if (parameters_.mixture) co_await sum_surface(lane, dynamics_.particles, places_.get(), filter_.own, fields_.surface);
    if (fluid_.by_finite_volumes()) co_await find_own_flux(lane);
}

tasks::Job CoupledStep::initialise(tasks::Lane& lane)
{
    co_await find_fraction(lane);
    co_await views_.tell_state(lane, filter_.own);
}

StabilityNumbers CoupledStep::stability(double dt, double bed_stiffness) const
{
    StabilityNumbers n;
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        const auto solid = fields_.sums.on(b)[sum_solid];
        core::for_each_cell(geometry(b).cells, [&](int i, int j, int k) { n.solid_fraction = std::max(n.solid_fraction, solid(i, j, k)); });
    }
    const double fluid_share = 1.0 - std::min(n.solid_fraction, 1.0 - smallest_closure_fraction);
    for (int g = 0; g < dynamics_.particles.owned; ++g) {
        const double ratio =
            dynamics_.particles.mass[std::size_t(g)] / (parameters_.fluid_density * exchange_.volume(dynamics_.particles, g));
        const double rate = exchange_.drag_rate(dynamics_.particles, g, fluid_share);
        n.stiffness = std::max(n.stiffness, dt * rate);
        n.softness = std::max(n.softness, rate * dynamics_.particles.mass[std::size_t(g)] / (dt * bed_stiffness));
        n.loading = std::max(n.loading, ratio * (1.0 - fluid_share) / fluid_share);
        n.amplification =
            std::max(n.amplification, added_mass_amplification(fluid_share, ratio, added_mass_coefficient(parameters_, fluid_share)));
    }
    return n;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// FluidViews: turbulence as grains meet it.
#include "physics/coupling/dispersion.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/fluid_views.hpp"

namespace physics {
namespace {

/// What nothing passes no fluctuation crosses: the deviation falls to zero there.
void close_boundaries(const BlockWalls& walls, core::View<double> deviation)
{
    for_each_mirrored(walls, deviation.extents(), 1, [&](const BlockSide& side, core::Index3 inside, core::Index3 beyond) {
        if (*side.kind == BoundaryKind::wall || side.slips()) deviation[beyond] = -deviation[inside];
    });
}

} // namespace

using core::LocalBlock;
using tasks::reads, tasks::updates, tasks::writes;

void FluidViews::see_turbulence(core::ScalarField& k, core::ScalarField& epsilon)
{
    k_ = &k;
    epsilon_ = &epsilon;
}

tasks::Job FluidViews::find_turbulence(tasks::Lane& lane, const core::ScalarField& k, const core::ScalarField& epsilon,
                                       core::FieldBatch<seen_of_turbulence>& seen)
{
    lane.team().run(mesh_.own_count(), [&](int b) {
        const auto out = seen.on(b);
        map_cells(out[seen_deviation], fluctuation_deviation, k.on(b));
        map_cells(out[seen_rate], fluctuation_rate, k.on(b), epsilon.on(b));
    });
    co_await fill_for_sampling(lane, mesh_, plan_, seen);
    lane.team().run(mesh_.own_count(), [&](int b) {
        const auto out = seen.on(b);
        close_boundaries(fluid_.walls()[std::size_t(b)], out[seen_deviation]);
        const auto& geometry = mesh_.geometry(b);
        gradient(geometry, geometry.wall_gradient, out[seen_deviation], {out[seen_growth], out[seen_growth + 1], out[seen_growth + 2]});
    });
    co_await fill_for_sampling(lane, mesh_, plan_, seen);
    lane.team().run(mesh_.own_count(), [&](int b) { close_boundaries(fluid_.walls()[std::size_t(b)], seen.on(b)[seen_deviation]); });
}

void FluidViews::declare_stirring(tasks::StageGraph& graph, const GrainLane& lane)
{
    if (!k_) return;
    graph.whole(
        "turbulence for grains",
        [this](tasks::Lane& own, const core::ScalarField& k, const core::ScalarField& epsilon, core::FieldBatch<seen_of_turbulence>& seen) {
            return find_turbulence(own, k, epsilon, seen);
        },
        reads(*k_, *epsilon_), writes(fields_.turbulence));
    graph.whole(
        "stir grains",
        [this, &exchange = lane.exchange](tasks::Lane& own, const core::FieldBatch<told_views>& told,
                                          const core::FieldBatch<seen_of_turbulence>& seen, const FluidClock& clock,
                                          const GrainPlaces& places, ParticleDynamics& grains) {
            const auto count = std::size_t(grains.particles.owned);
            const GrainTable views = sample(own.team(), places, count, told), turbulence = sample(own.team(), places, count, seen);
            exchange.stir(grains.particles, views, turbulence, {clock.dt, std::uint64_t(clock.step)});
        },
        reads(fields_.told, fields_.turbulence, lane.clock, lane.places), updates(lane.grains));
}

} // namespace physics

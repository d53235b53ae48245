// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep, what mixtures of sizes need: the surface of the grains around each grain, hence their mean diameter.
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/coupled_step.hpp"
#include "physics/steps/sum_per_volume.hpp"

namespace physics {

using tasks::reads, tasks::writes;

/// Before the sub-steps: at the places where the last step left the grains.
void CoupledStep::declare_sizes(tasks::StageGraph& graph)
{
    if (!parameters_.mixture) return;
    graph.whole(
        "sizes around grains",
        [this](tasks::Lane& lane, const core::FieldBatch<1>& surface, const GrainPlaces& places, const ParticleDynamics& grains,
               std::vector<double>& around) {
            around.resize(std::size_t(grains.particles.owned));
            lane.team().run(mesh_.own_count(), [&](int b) { places.sample(b, surface.on(b)[0], around); });
        },
        reads(fields_.surface, places_, grains_), writes(surface_));
}

/// After them: what the next step samples. It follows from the places of the grains, so no checkpoint has it.
void CoupledStep::declare_surface(tasks::StageGraph& graph)
{
    if (!parameters_.mixture) return;
    graph.whole(
        "surface of grains",
        [this](tasks::Lane& lane, const ParticleDynamics& grains, const GrainPlaces& places, Filter& filter, core::FieldBatch<1>& surface) {
            return sum_surface(lane, grains.particles, places, filter, surface);
        },
        reads(grains_, places_), writes(filter_.stage_part, fields_.surface));
    graph.sink(fields_.surface);
}

tasks::Job CoupledStep::sum_surface(tasks::Lane& lane, const core::ParticleSet& grains, const GrainPlaces& places, Filter& filter,
                                    core::FieldBatch<1>& surface)
{
    GrainTable deposits(1, std::vector<double>(std::size_t(grains.owned)));
    for (int g = 0; g < grains.owned; ++g) {
        const auto k = std::size_t(g);
        deposits[0][k] = exchange_.volume(grains, g) / (2.0 * grains.radius[k]);
    }
    co_await sum_per_volume(lane, mesh_, views_.plan(), places, std::move(deposits), surface);
    co_await filter_batch(lane, filter, surface);
    co_await fill_for_sampling(lane, mesh_, views_.plan(), surface);
}

} // namespace physics

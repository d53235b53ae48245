// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sums over grains per volume of the cells around them.
#include "physics/coupling/grain_exchange.hpp"
#include "physics/coupling/grain_places.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/steps/batch_filter.hpp"

namespace physics {

/// Deposits one column for each array of a batch; nothing is filtered. Collective.
template <std::size_t N>
tasks::Job sum_per_volume(tasks::Lane& lane, const core::Mesh& mesh, const core::HaloExchange& plan, const GrainPlaces& places,
                          GrainTable deposits, core::FieldBatch<N>& sums)
{
    lane.team().run(mesh.own_count(), [&](int b) {
        for (std::size_t a = 0; a < N; ++a) {
            auto& values = sums.data(b, a);
            std::fill(values.begin(), values.end(), 0.0);
            places.deposit(b, deposits[a], sums.on(b)[a]);
        }
    });
    co_await send_home(lane, mesh, plan, sums);
    lane.team().run(mesh.own_count(), [&](int b) {
        for (const auto& field : sums.on(b))
            map_cells(
                field, [](double q, double volume) { return q / volume; }, field, mesh.geometry(b).volume.view());
    });
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The coupling filter on batches of fields of any size.
#include "core/comm/halo.hpp"
#include "core/field/batch.hpp"
#include "core/field/sample.hpp"
#include "physics/steps/filter_job.hpp"

namespace physics {

/// Filters the first `arrays` of a batch, as many at a time as the filter takes.
template <std::size_t N>
tasks::Job filter_batch(tasks::Lane& lane, Filter& filter, core::FieldBatch<N>& batch, std::size_t arrays = N)
{
    const int room = filter.room();
    for (int first = 0; first < int(arrays); first += room) {
        const int count = std::min(room, int(arrays) - first);
        filter.put(lane.team(), count,
                   [&](core::LocalBlock b, int n) { return core::View<const double>(batch.on(b)[std::size_t(first + n)]); });
        co_await run(lane, filter, count);
        filter.take(lane.team(), count, [&](core::LocalBlock b, int n) { return batch.on(b)[std::size_t(first + n)]; });
    }
}

/// Fills the first halo layer of a batch, walls included, so that grains can sample it.
template <std::size_t N>
tasks::Job fill_for_sampling(tasks::Lane& lane, const core::Mesh& mesh, const core::HaloExchange& plan, core::FieldBatch<N>& batch)
{
    core::HaloExchange::Flight flight;
    {
        const auto mpi = lane.messages();
        plan.start(batch, flight, lane.communicator());
    }
    co_await lane.arrive(flight.pending);
    plan.finish(batch, flight);
    lane.team().run(mesh.own_count(), [&](int b) {
        for (const auto& field : batch.on(b)) core::mirror_even(mesh, b, field);
    });
}

/// Sends what was deposited in halos to the cells it belongs to.
template <std::size_t N>
tasks::Job send_home(tasks::Lane& lane, const core::Mesh& mesh, const core::HaloExchange& plan, core::FieldBatch<N>& batch)
{
    lane.team().run(mesh.own_count(), [&](int b) {
        for (const auto& field : batch.on(b)) core::mirror_even_transpose(mesh, b, field);
    });
    core::HaloExchange::Flight flight;
    {
        const auto mpi = lane.messages();
        plan.start_transpose(batch, flight, lane.communicator());
    }
    co_await lane.arrive(flight.pending);
    plan.finish_transpose(batch, flight);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/mesh_halo_filler.hpp"

namespace physics {
namespace {

template <class Field>
tasks::Job fill_field(tasks::Lane& lane, const core::HaloExchange& plan, Field& field)
{
    core::HaloExchange::Flight flight;
    {
        const auto lock = lane.messages();
        plan.start(field, flight, lane.communicator());
    }
    co_await lane.arrive(flight.pending);
    lane.attempt([&] { plan.finish(field, flight); });
}

template <class Field>
tasks::Job send_field_home(tasks::Lane& lane, const core::HaloExchange& plan, Field& field)
{
    core::HaloExchange::Flight flight;
    {
        const auto lock = lane.messages();
        plan.start_transpose(field, flight, lane.communicator());
    }
    co_await lane.arrive(flight.pending);
    lane.attempt([&] { plan.finish_transpose(field, flight); });
}

} // namespace

const core::HaloExchange& MeshHaloFiller::plan(int field_halo, int width)
{
    auto& plan = plans_[{field_halo, width}];
    if (!plan) plan = std::make_unique<core::HaloExchange>(mesh_, communicator_, field_halo, width, core::HaloShape::full);
    return *plan;
}

tasks::Job MeshHaloFiller::fill(tasks::Lane& lane, tasks::FieldRef field, int width)
{
    return std::visit([&](auto* f) { return fill_field(lane, *plans_.at({f->info().halo, width}), *f); }, field);
}

tasks::Job send_home(tasks::Lane& lane, const core::HaloExchange& plan, core::ScalarField& field)
{
    return send_field_home(lane, plan, field);
}

tasks::Job send_home(tasks::Lane& lane, const core::HaloExchange& plan, core::VectorField& field)
{
    return send_field_home(lane, plan, field);
}

} // namespace physics

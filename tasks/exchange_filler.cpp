// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/exchange_filler.hpp"

namespace tasks {
namespace {

int halo_of(FieldRef field)
{
    return std::visit([](const auto* f) { return f->info().halo; }, field);
}

} // namespace

void ExchangeFiller::prepare(FieldRef field, core::HaloReach reach)
{
    const std::pair key{halo_of(field), reach};
    if (!exchanges_.contains(key)) exchanges_.try_emplace(key, mesh_, ranks_, key.first, reach.width, reach.shape);
}

Job ExchangeFiller::fill(Lane& lane, FieldRef field, core::HaloReach reach)
{
    const core::HaloExchange& exchange = exchanges_.at({halo_of(field), reach});
    core::HaloExchange::Flight flight;
    {
        const auto mpi = lane.messages();
        std::visit([&](auto* f) { exchange.start(*f, flight, lane.communicator()); }, field);
    }
    co_await lane.arrive(flight.pending);
    std::visit([&](auto* f) { exchange.finish(*f, flight); }, field);
}

} // namespace tasks

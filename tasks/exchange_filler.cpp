// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/exchange_filler.hpp"

namespace tasks {
namespace {

const core::FieldInfo& info_of(FieldRef field)
{
    return std::visit([](const auto* f) -> const core::FieldInfo& { return f->info(); }, field);
}

} // namespace

void ExchangeFiller::prepare(FieldRef field, core::HaloReach reach)
{
    const Key key = key_of(field, reach);
    if (!exchanges_.contains(key)) exchanges_.try_emplace(key, mesh_, ranks_, std::get<0>(key), reach.width, reach.shape, std::get<1>(key));
}

ExchangeFiller::Key ExchangeFiller::key_of(FieldRef field, core::HaloReach reach) const
{
    using Behind = core::HaloExchange::Behind;
    const core::FieldInfo& info = info_of(field);
    const bool all = info.at_sub_faces && !mesh_.topology().joints.interfaces.empty();
    return {info.halo, all ? Behind::all : Behind::cells, reach};
}

Job ExchangeFiller::fill(Lane& lane, FieldRef field, core::HaloReach reach)
{
    const core::HaloExchange& exchange = exchanges_.at(key_of(field, reach));
    core::HaloExchange::Flight flight;
    {
        const auto mpi = lane.messages();
        std::visit([&](auto* f) { exchange.start(*f, flight, lane.communicator()); }, field);
    }
    co_await lane.arrive(flight.pending);
    std::visit([&](auto* f) { exchange.finish(*f, flight); }, field);
}

} // namespace tasks

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Deposits that fell into halos go home to the cells they belong to: the transpose of filling halos.
#include "core/comm/halo.hpp"
#include "tasks/lane.hpp"

namespace physics {

template <std::size_t N>
[[nodiscard]] tasks::Job send_home(tasks::Lane& lane, const core::HaloExchange& plan, core::FieldStorage<N>& field)
{
    core::HaloExchange::Flight flight;
    {
        const auto mpi = lane.messages();
        plan.start_transpose(field, flight, lane.communicator());
    }
    co_await lane.arrive(flight.pending);
    plan.finish_transpose(field, flight);
}

} // namespace physics

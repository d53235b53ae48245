// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/filter_job.hpp"

namespace physics {

tasks::Job set_up(tasks::Lane& lane, Filter& filter, Coefficients transmissibility, const core::ScalarField& volume)
{
    double bound = 0.0;
    lane.attempt([&] {
        filter.load(lane.team(), transmissibility, volume);
        bound = filter.eigenvalue_bound();
    });
    co_await lane.max(std::span(&bound, 1));
    filter.set_bound(bound); // throws on all ranks alike
}

tasks::Job run(tasks::Lane& lane, Filter& filter, int fields)
{
    if (!filter.has_ghosts()) {
        lane.attempt([&] { filter.run(lane.team(), fields); });
        co_return;
    }
    for (int number = 1; number <= filter.degree(); ++number) {
        core::Pending pending;
        {
            const auto mpi = lane.messages();
            filter.start_ghosts(number, fields, lane.communicator(), pending);
        }
        co_await lane.arrive(pending);
        lane.attempt([&] { filter.pass(lane.team(), number, fields); });
    }
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs a Krylov solver inside a stage: whatever it asks for may wait for messages without holding a thread.
#include "physics/fluid/krylov.hpp"
#include "tasks/lane.hpp"

namespace physics {

/// @param system  apply(lane, in, out) and precondition(lane, in, out) return jobs.
template <class System>
tasks::Job drive(tasks::Lane& lane, KrylovProcess process, System& system)
{
    while (process.next()) {
        const KrylovDemand demand = process.demand();
        switch (demand.kind) {
        case KrylovDemand::Kind::apply: co_await system.apply(lane, demand.in, demand.out); break;
        case KrylovDemand::Kind::precondition: co_await system.precondition(lane, demand.in, demand.out); break;
        case KrylovDemand::Kind::sum: co_await lane.sum(demand.in); break;
        }
    }
}

} // namespace physics

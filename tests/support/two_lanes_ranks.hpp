// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The checks of the two-lane step that every number of ranks has to pass.
#include "tasks/executor.hpp"
#include "tests/support/two_lanes.hpp"
#include <doctest/doctest.h>

namespace support {

inline std::vector<double> two_lanes_state(const core::Communicator& ranks, const std::string& kind, int threads)
{
    TwoLanes problem(ranks);
    const auto plan = problem.graph().compile();
    const auto executor = tasks::make_executor({kind, threads, nullptr}, plan);
    for (int step = 0; step < 5; ++step) executor->run_step(step);
    return problem.state();
}

/// Shuffled ranks begin their lanes in different orders: nobody may wait for ever, and no bit may change.
inline void check_two_lanes_on_all_ranks()
{
    const auto world = core::Communicator::world();
    const auto expected = two_lanes_state(core::Communicator::self(), "serial", 1);
    for (const std::string kind : {"serial", "openmp", "tbb"}) {
        CAPTURE(kind);
        CHECK(two_lanes_state(world, kind, 1) == expected);
        CHECK(two_lanes_state(world, kind, 2) == expected);
    }
    for (int seed = 0; seed < 20; ++seed) CHECK(two_lanes_state(world, "shuffle:" + std::to_string(seed), 1) == expected);
}

} // namespace support

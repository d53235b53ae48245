// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Two lanes of equal work that both talk between ranks after every piece: how much of the waiting the other lane hides.
// Run it on one rank with two threads, and on two ranks: mpirun -n 2 --bind-to none lane_overlap.
#include "core/comm/communicator.hpp"
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int pieces = 40, chunks = 2, steps = 50;
constexpr double piece = 40e-6; // [s]

/// Works for `seconds` of wall time.
void work(double seconds)
{
    for (const auto begin = Clock::now(); std::chrono::duration<double>(Clock::now() - begin).count() < seconds;) {}
}

/// Ranks are slow in turn, so that everyone waits for the other one.
tasks::Job talk(tasks::Lane& lane, double& sum)
{
    for (int p = 0; p < pieces; ++p) {
        const bool slow = (p + lane.communicator().rank()) % 2 == 0;
        lane.team().run(chunks, [&](int) { work((slow ? 1.5 : 0.5) * piece / chunks); });
        sum = 1.0;
        co_await lane.sum(std::span(&sum, 1));
    }
}

} // namespace

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
    const auto world = core::Communicator::world();
    tasks::Value<double> fluid("fluid", 0.0), particles("particles", 0.0);
    tasks::StageGraph graph(tasks::Layout{{1}, 1}, world);
    for (auto* value : {&fluid, &particles}) {
        const auto lane = graph.lane(std::string(value->name()));
        graph.whole("talk", talk, tasks::updates(*value));
        graph.sink(*value);
    }
    const auto plan = graph.compile();
    for (const std::string kind : {"serial", "openmp", "tbb"}) {
        tasks::Trace trace;
        const auto executor = tasks::make_executor({kind, world.size() == 1 ? 2 : 1, &trace}, plan);
        double fastest = 1.0;
        for (int step = 0; step < steps; ++step) {
            const auto begin = Clock::now();
            executor->run_step(step);
            fastest = std::min(fastest, std::chrono::duration<double>(Clock::now() - begin).count());
        }
        if (world.rank() == 0) std::cout << kind << ": fastest step " << 1e3 * fastest << " ms; " << trace.digest(plan) << '\n';
    }
}

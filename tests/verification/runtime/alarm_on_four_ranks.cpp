// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=4 timeout=60
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"
#include <doctest/doctest.h>

#include <vector>

using namespace tasks;

namespace {

/// Sends to the next rank and waits for the rank before; rank 1 leaves without a word if it is broken.
Job pass_on(Lane& lane, bool broken, std::vector<double>& values)
{
    const auto& ranks = lane.communicator();
    if (broken && ranks.rank() == 1) throw core::NumericsError("no more");
    std::vector<double> from(values.size()); // long messages: the sender, too, waits for the receiver
    core::Pending pending;
    {
        const auto mpi = lane.messages();
        const int next = (ranks.rank() + 1) % ranks.size(), previous = (ranks.rank() + ranks.size() - 1) % ranks.size();
        ranks.receive(std::as_writable_bytes(std::span(from)), previous, 0, pending);
        ranks.send(std::as_bytes(std::span(values)), next, 0, pending);
    }
    co_await lane.arrive(pending);
    values = from;
}

} // namespace

TEST_CASE("a job that leaves its messages on one rank hangs nobody, and the next step runs with clean messages")
{
    const auto world = core::Communicator::world();
    Value<bool> broken("broken", false);
    Value<std::vector<double>> passed("passed");
    Value<double> total("total", 0.0);
    StageGraph graph(Layout{{1}, 1}, world);
    graph.whole("pass on", pass_on, reads(broken), updates(passed));
    graph.whole(
        "other lane",
        [](Lane& lane, double& sum) -> Job {
            for (int i = 0; i < 20; ++i) {
                sum = 1.0;
                co_await lane.sum(std::span(&sum, 1));
            }
        },
        updates(total));
    graph.sink(passed);
    graph.sink(total);
    const Plan plan = graph.compile();
    for (const std::string kind : {"serial", "shuffle:5", "openmp", "tbb"}) {
        CAPTURE(kind);
        const auto executor = make_executor({kind, 1, nullptr}, plan);
        for (int step = 0; step < 6; ++step) {
            passed.get().assign(100'000, double(10 * step + world.rank()));
            broken.get() = step % 2 == 1;
            if (broken.get()) {
                CHECK_THROWS_WITH_AS(executor->run_step(step),
                                     core::text("step ", step, ", rank 1: stage 'pass on' failed: no more").c_str(), StepFailure);
            } else {
                executor->run_step(step);
                CHECK(passed.get().back() == 10 * step + (world.rank() + 3) % 4);
                CHECK(total.get() == 4.0);
            }
        }
    }
}

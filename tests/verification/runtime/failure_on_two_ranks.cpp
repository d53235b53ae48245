// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=60
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"
#include <doctest/doctest.h>

using namespace tasks;

namespace {

const std::string kinds[] = {"serial", "shuffle:5", "openmp", "tbb"};

/// What run_step says on this rank; empty if it succeeds.
std::string words(Executor& executor, std::int64_t step)
{
    try {
        executor.run_step(step);
        return "";
    } catch (const StepFailure& failure) {
        return failure.what();
    }
}

} // namespace

TEST_CASE("a block that fails on one rank stops both, with the same words, and the next step runs")
{
    const auto world = core::Communicator::world();
    const std::vector<core::Extents> blocks(1, {2, 1, 1});
    core::ScalarField a({"a", "-", 0, false}, blocks);
    Value<bool> broken("broken", world.rank() == 1);
    Value<double> total("total", 0.0);
    Value<int> written("written", 0);
    StageGraph graph(Layout{{2}, 1}, world);
    graph.each_block(
        "divide",
        [](int, bool is_broken, core::View<double>) {
            if (is_broken) throw core::NumericsError("division by zero");
        },
        reads(broken), updates(a));
    graph.whole(
        "iterate",
        [](Lane& lane, const core::ScalarField&, double& sum) -> Job {
            for (int i = 0; i < 10; ++i) {
                sum = 1.0;
                co_await lane.sum(std::span(&sum, 1));
            }
        },
        reads(a), writes(total));
    graph
        .whole(
            "write", [](Lane&, double, int& n) { ++n; }, reads(total), updates(written))
        .effect();
    const Plan plan = graph.compile();
    for (const auto& kind : kinds) {
        CAPTURE(kind);
        const auto executor = make_executor({kind, 1, nullptr}, plan);
        written.get() = 0;
        broken.get() = world.rank() == 1;
        CHECK(words(*executor, 3) == "step 3, rank 1: stage 'divide' failed on its block 0: division by zero");
        CHECK(written.get() == 0);
        broken.get() = false;
        CHECK(words(*executor, 4).empty());
        CHECK(total.get() == 2.0);
        CHECK(written.get() == 1);
    }
}

TEST_CASE("a loop that fails inside a job on one rank ends the job on both at its next sum")
{
    const auto world = core::Communicator::world();
    Value<int> sweeps("sweeps", 0);
    StageGraph graph(Layout{{1}, 1}, world);
    graph.whole(
        "solve",
        [&world](Lane& lane, int& n) -> Job {
            for (n = 0; n < 100; ++n) {
                lane.team().run(2, [&](int) {
                    if (world.rank() == 0 && n == 5) throw core::NumericsError("diverged");
                });
                co_await lane.agree();
            }
        },
        writes(sweeps));
    graph.sink(sweeps);
    const Plan plan = graph.compile();
    for (const auto& kind : kinds) {
        CAPTURE(kind);
        CHECK(words(*make_executor({kind, 1, nullptr}, plan), 0) == "step 0, rank 0: stage 'solve' failed: diverged");
        CHECK(sweeps.get() == 5);
    }
}

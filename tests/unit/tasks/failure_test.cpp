// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"
#include <doctest/doctest.h>

using namespace tasks;

TEST_CASE("a failure stops what follows, names stage, block and step, and leaves the graph usable")
{
    const std::vector<core::Extents> blocks(3, {2, 1, 1});
    core::ScalarField a({"a", "-", 0, false}, blocks);
    Value<bool> broken("broken", true);
    Value<int> later("later", 0);
    StageGraph graph(Layout{{2, 2, 2}, 1}, core::Communicator::self());
    graph.each_block(
        "divide",
        [](int block, bool is_broken, core::View<double>) {
            if (is_broken && block == 1) throw core::NumericsError("division by zero");
        },
        reads(broken), updates(a));
    graph.whole(
        "loop", [](Lane& lane, core::ScalarField&) -> Job { co_await lane.agree(); }, updates(a));
    graph
        .whole(
            "count", [](Lane&, const core::ScalarField&, int& n) { ++n; }, reads(a), updates(later))
        .effect();
    const Plan plan = graph.compile();
    for (const std::string kind : {"serial", "shuffle:3", "openmp", "tbb"}) {
        CAPTURE(kind);
        const auto executor = make_executor({kind, 2, nullptr}, plan);
        broken.get() = true;
        later.get() = 0;
        CHECK_THROWS_WITH_AS(executor->run_step(7), "step 7, rank 0: stage 'divide' failed on its block 1: division by zero", StepFailure);
        CHECK(later.get() == 0);
        broken.get() = false;
        for (int step = 8; step < 11; ++step) executor->run_step(step);
        CHECK(later.get() == 3);
    }
}

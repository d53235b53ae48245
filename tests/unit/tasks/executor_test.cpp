// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/executor.hpp"
#include "tests/support/two_lanes.hpp"
#include <doctest/doctest.h>

using namespace tasks;

namespace {

std::vector<double> state_after_steps(support::TwoLanes& problem, const Plan& plan, const std::string& kind, int threads)
{
    problem.reset();
    const auto executor = make_executor({kind, threads, nullptr}, plan);
    for (int step = 0; step < 5; ++step) executor->run_step(step);
    return problem.state();
}

} // namespace

TEST_CASE("all executors give the same bits with any number of threads and in any legal order")
{
    support::TwoLanes problem(core::Communicator::self());
    const Plan plan = problem.graph().compile();
    const auto expected = state_after_steps(problem, plan, "serial", 1);
    for (const int threads : {1, 2, 4})
        for (const std::string kind : {"openmp", "tbb"}) {
            CAPTURE(kind);
            CAPTURE(threads);
            CHECK(state_after_steps(problem, plan, kind, threads) == expected);
        }
    for (int seed = 0; seed < 20; ++seed) CHECK(state_after_steps(problem, plan, "shuffle:" + std::to_string(seed), 1) == expected);
}

TEST_CASE("an undeclared read is caught by a shuffled order")
{
    const std::vector<core::Extents> blocks(2, {4, 1, 1});
    core::ScalarField a({"a", "-", 0, false}, blocks), b({"b", "-", 0, false}, blocks);
    Value<double> steps("steps", 0.0);
    StageGraph graph(Layout{{4, 4}, 1}, core::Communicator::self());
    graph.whole(
        "count", [](Lane&, double& n) { n += 1.0; }, updates(steps));
    graph.each_block(
        "set a", [](int block, double n, core::View<double> v) { v(0, 0, 0) = n + block; }, reads(steps), writes(a));
    graph.each_block(
        "set b", [&a](int block, core::View<double> v) { v(0, 0, 0) = a.on(block)(0, 0, 0); }, writes(b));
    graph.sink(a);
    graph.sink(b);
    const Plan plan = graph.compile();
    const auto result = [&](const std::string& kind) {
        steps.get() = 0.0;
        a.on(0)(0, 0, 0) = a.on(1)(0, 0, 0) = 0.0;
        make_executor({kind, 1, nullptr}, plan)->run_step(0);
        return std::pair{b.on(0)(0, 0, 0), b.on(1)(0, 0, 0)};
    };
    int caught = 0;
    for (int seed = 0; seed < 20; ++seed) caught += result("shuffle:" + std::to_string(seed)) != result("serial");
    CHECK(caught > 10);
}

TEST_CASE("a kind of executor that does not exist is refused with the kinds that do")
{
    StageGraph graph(Layout{{1}, 1}, core::Communicator::self());
    const Plan plan = graph.compile();
    CHECK_THROWS_WITH_AS(make_executor({"fast", 1, nullptr}, plan),
                         "executor 'fast' does not exist: choose auto, serial, shuffle:SEED, openmp or tbb", core::ConfigError);
    CHECK_THROWS_AS(make_executor({"shuffle:x", 1, nullptr}, plan), core::ConfigError);
    CHECK_THROWS_AS(make_executor({"tbb", 0, nullptr}, plan), core::ConfigError);
}

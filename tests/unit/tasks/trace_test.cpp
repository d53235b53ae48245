// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace tasks;

namespace {

/// Two lanes of two stages that depend on each other within the lane.
class TwoChains {
public:
    TwoChains() : graph_(Layout{{1}, 1}, core::Communicator::self())
    {
        declare("fluid", fluid_);
        declare("particles", particles_);
    }
    [[nodiscard]] Plan plan() { return graph_.compile(); }

private:
    void declare(const std::string& label, Value<int>& value)
    {
        const auto lane = graph_.lane(label);
        graph_.whole(
            label + " first", [](Lane&, int& n) { ++n; }, updates(value));
        graph_.whole(
            label + " second", [](Lane&, int& n) { ++n; }, updates(value));
        graph_.sink(value);
    }
    Value<int> fluid_{"fluid", 0}, particles_{"particles", 0};
    StageGraph graph_;
};

} // namespace

TEST_CASE("the digest of a trace made by hand has the hand-computed sums")
{
    TwoChains chains;
    const Plan plan = chains.plan(); // nodes 0, 1 are the fluid, 2, 3 the particles
    Trace trace;
    trace.add({0, 0, 1, 0.0, 1.0});
    trace.add({2, 0, 1, 1.5, 3.0}); // begins while the fluid waits from 1 to 4
    trace.add({0, 0, 1, 4.0, 5.0});
    trace.add({1, 0, 1, 5.0, 7.0});
    trace.add({3, 0, 1, 7.0, 8.0});
    trace.add({0, 0, 2, 9.0, 9.5}); // a step that is not complete does not count
    const Digest digest = trace.digest(plan);
    CHECK(digest.steps == 1);
    CHECK(digest.wall == 8.0);
    CHECK(digest.work == 6.5);
    CHECK(digest.lanes.at("fluid") == 4.0);
    CHECK(digest.lanes.at("particles") == 2.5);
    CHECK(digest.longest == 4.0); // fluid: 1 + 1 + 2
    CHECK(digest.overlap == 1.5); // particles work while the fluid waits
    CHECK(digest.exposed == 1.5); // 1 to 1.5 and 3 to 4
    CHECK(digest.imbalance == 0.0);
}

TEST_CASE("a ring keeps the last spans")
{
    Trace trace(3);
    for (int step = 0; step < 5; ++step) trace.add({0, 0, step, double(step), step + 0.5});
    REQUIRE(trace.spans().size() == 3);
    CHECK(trace.spans().front().step == 2);
}

TEST_CASE("a traced run gives a file that Perfetto reads, one event for each node and step")
{
    TwoChains chains;
    const Plan plan = chains.plan();
    Trace trace;
    const auto executor = make_executor({"tbb", 2, &trace}, plan);
    for (int step = 0; step < 3; ++step) executor->run_step(step);
    const auto file = std::filesystem::temp_directory_path() / "isago_trace_test.json";
    trace.write(plan, 0, file);
    const auto written = nlohmann::json::parse(std::ifstream(file));
    std::filesystem::remove(file);
    REQUIRE(written["traceEvents"].size() == 12);
    CHECK(written["traceEvents"][0]["ph"] == "X");
    CHECK(trace.digest(plan).steps == 3);
    CHECK(trace.digest(plan).longest <= trace.digest(plan).work);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/communicator.hpp"
#include "tasks/lane.hpp"
#include <doctest/doctest.h>

using namespace tasks;

namespace {

const core::SerialTeam team;

Job add(Lane& lane, int& total, int depth)
{
    if (depth > 0) co_await add(lane, total, depth - 1);
    ++total;
}

Job send_to_myself(Lane& lane, double& result)
{
    const double sent = 42.0;
    core::Pending pending;
    {
        const auto mpi = lane.messages();
        lane.communicator().receive(std::as_writable_bytes(std::span(&result, 1)), 0, 0, pending);
        lane.communicator().send(std::as_bytes(std::span(&sent, 1)), 0, 0, pending);
    }
    co_await lane.arrive(pending);
}

Job fail() // a job of its own, so that the exception crosses a co_await
{
    throw core::NumericsError("not a number");
    co_return;
}

} // namespace

TEST_CASE("jobs nest, and a deep chain of them needs no deep stack")
{
    int total = 0;
    run(core::Communicator::self(), team, [&](Lane& lane) { return add(lane, total, 10'000); });
    CHECK(total == 10'001);
}

TEST_CASE("a job waits for its messages")
{
    double result = 0.0;
    run(core::Communicator::self(), team, [&](Lane& lane) { return send_to_myself(lane, result); });
    CHECK(result == 42.0);
}

TEST_CASE("an exception passes through the jobs that wait for it")
{
    bool passed = false;
    const auto outer = [&](Lane&) -> Job {
        try {
            co_await fail();
        } catch (const core::NumericsError&) {
            passed = true;
            throw;
        }
    };
    CHECK_THROWS_AS(run(core::Communicator::self(), team, outer), core::NumericsError);
    CHECK(passed);
}

TEST_CASE("a chunk that fails is reported when the job ends; later loops do nothing")
{
    int later = 0;
    const auto job = [&](Lane& lane) -> Job {
        lane.team().run(2, [](int) { throw core::NumericsError("overflow in a chunk"); });
        lane.team().run(2, [&](int) { ++later; });
        co_await lane.agree();
        ++later;
    };
    CHECK_THROWS_WITH_AS(run(core::Communicator::self(), team, job), "step 0, rank 0: stage 'job' failed: overflow in a chunk",
                         StepFailure);
    CHECK(later == 0);
}

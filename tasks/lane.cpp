// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/lane.hpp"

#include <algorithm>
#include <deque>
#include <vector>

namespace tasks {

void GuardedTeam::run(int chunks, const std::function<void(int)>& body) const
{
    if (poison_.set()) return;
    team_.run(chunks, [&](int chunk) {
        if (poison_.set()) return;
        try {
            body(chunk);
        } catch (...) {
            poison_.record(std::current_exception(), stage_, -1);
        }
        pump_.poll();
    });
}

Lane::Lane(std::string stage, LaneContext context, const core::Communicator& communicator)
    : stage_(std::move(stage)),
      context_(std::move(context)),
      communicator_(communicator),
      team_(context_.team, context_.pump, context_.poison, stage_)
{
}

bool Lane::Arrival::await_ready()
{
    const std::unique_lock mpi(context_.pump.token(), std::try_to_lock);
    return mpi && messages_.done();
}

void Lane::Arrival::await_suspend(std::coroutine_handle<> job)
{
    context_.pump.wait_for(messages_, [&resume = context_.resume, job](Outcome o) { resume(job, o); });
}

Lane::Arrival Lane::arrive(core::Pending& messages) { return {context_, messages}; }
Job Lane::sum(std::span<double> values) { return reduce(values, Operation::sum); }
Job Lane::max(std::span<double> values) { return reduce(values, Operation::max); }

Job Lane::reduce(std::span<double> values, Operation operation)
{
    if (communicator_.size() == 1) {
        if (poisoned()) throw Poisoned{};
        co_return;
    }
    std::vector<double> buffer(values.begin(), values.end());
    buffer.push_back(poisoned() ? 1.0 : 0.0);
    core::Pending pending;
    {
        const auto mpi = messages();
        if (operation == Operation::sum) communicator_.start_sum(buffer, pending);
        else communicator_.start_max(buffer, pending);
    }
    co_await arrive(pending);
    // Only what was reduced decides: a failure here since then must not make this rank leave alone.
    if (buffer.back() > 0.0) {
        context_.poison.spread();
        throw Poisoned{};
    }
    std::copy_n(buffer.begin(), values.size(), values.begin());
}

void run(const core::Communicator& communicator, const core::Team& team, const std::function<Job(Lane&)>& job)
{
    MessagePump pump;
    Poison poison;
    poison.clear(0, communicator.rank());
    std::deque<std::coroutine_handle<>> arrived;
    Lane lane("job", {team, pump, poison, [&](std::coroutine_handle<> h, Outcome) { arrived.push_back(h); }}, communicator);
    bool ended = false;
    std::exception_ptr error;
    Job running = job(lane);
    running.start([&](std::exception_ptr e) {
        ended = true;
        error = std::move(e);
    });
    for (core::Patience patience; !ended;) {
        pump.poll_idle(patience);
        for (; !arrived.empty(); arrived.pop_front()) arrived.front().resume();
    }
    try {
        if (error) std::rethrow_exception(error);
    } catch (const Poisoned&) { // thrown on all ranks alike
        throw StepFailure(poison.agree(communicator, [] {}).value());
    }
    if (const auto failure = poison.first()) throw StepFailure(*failure);
}

} // namespace tasks

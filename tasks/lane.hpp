// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the kernel of a whole stage gets besides its data: threads for its loops, and messages that hold no thread.
#include "core/base/team.hpp"
#include "core/comm/communicator.hpp"
#include "tasks/failure.hpp"
#include "tasks/job.hpp"
#include "tasks/message_pump.hpp"
#include <coroutine>
#include <functional>
#include <mutex>
#include <span>
#include <string>

namespace tasks {

/// A suspended job's messages are there: continue it on some thread. Or they will never come: leave it.
using Resume = std::function<void(std::coroutine_handle<>, Outcome)>;

/// Runs loops on another team; an exception in a chunk is recorded instead of thrown, and poisons the step.
class GuardedTeam final : public core::Team {
public:
    GuardedTeam(const core::Team& team, MessagePump& pump, Poison& poison, std::string stage)
        : team_(team), pump_(pump), poison_(poison), stage_(std::move(stage))
    {
    }
    void run(int chunks, const std::function<void(int)>& body) const override;
    [[nodiscard]] int threads() const override { return team_.threads(); }

private:
    const core::Team& team_;
    MessagePump& pump_;
    Poison& poison_;
    std::string stage_;
};

/// Where a lane runs: parts of an executor that outlive it.
struct LaneContext {
    const core::Team& team;
    MessagePump& pump;
    Poison& poison;
    Resume resume;
};

class Lane {
public:
    /// @param communicator  A space of messages that no other lane uses; must outlive the lane.
    Lane(std::string stage, LaneContext context, const core::Communicator& communicator);
    Lane(const Lane&) = delete;
    Lane& operator=(const Lane&) = delete;

    /// For loops inside the stage. A chunk that throws poisons the step; poisoned loops do nothing.
    [[nodiscard]] const core::Team& team() const { return team_; }
    /// Messages of this stage only. Hold messages() while calling it.
    [[nodiscard]] const core::Communicator& communicator() const { return communicator_; }
    /// Owns MPI as long as the lock lives; never across a co_await or a loop of team().
    [[nodiscard]] std::unique_lock<std::mutex> messages() { return std::unique_lock(context_.pump.token()); }
    [[nodiscard]] std::mutex& token() { return context_.pump.token(); }
    [[nodiscard]] bool poisoned() const { return context_.poison.set(); }

    /// A computation between messages that may fail: an exception is recorded and the job goes on to its next sum, where all
    /// ranks leave together. Does nothing once poisoned.
    template <class Body>
    void attempt(Body body)
    {
        if (poisoned()) return;
        try {
            body();
        } catch (...) {
            context_.poison.record(std::current_exception(), stage_, -1);
        }
    }

    class Arrival;
    /// co_await lane.arrive(pending): until the messages are there; other work runs meanwhile.
    [[nodiscard]] Arrival arrive(core::Pending& messages);
    /// co_await lane.sum(values): element-wise over all ranks, in place. Give every block a slot of its own and add the slots
    /// in a fixed order: then the bits do not depend on the number of ranks.
    /// @throws Poisoned on all ranks alike if one of them has failed.
    Job sum(std::span<double> values);
    /// co_await lane.max(values): likewise.
    Job max(std::span<double> values);
    /// All ranks learn whether one of them has failed. @throws Poisoned on all ranks alike.
    Job agree() { return sum({}); }

private:
    enum class Operation { sum, max };
    Job reduce(std::span<double> values, Operation operation);

    std::string stage_;
    LaneContext context_;
    const core::Communicator& communicator_;
    GuardedTeam team_;
};

class Lane::Arrival {
public:
    Arrival(LaneContext& context, core::Pending& messages) : context_(context), messages_(messages) {}
    [[nodiscard]] bool await_ready();
    void await_suspend(std::coroutine_handle<> job);
    void await_resume() const {}

private:
    LaneContext& context_;
    core::Pending& messages_;
};

/// Runs one job alone, outside any graph, and waits for its end: set-up and tests.
/// @throws what the job throws, or StepFailure for a failure recorded by its loops, on this rank.
void run(const core::Communicator& communicator, const core::Team& team, const std::function<Job(Lane&)>& job);

} // namespace tasks

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What all executors share: runs one node of a plan, keeps its failures, traces it, and lets its job wait for messages.
#include "tasks/plan.hpp"
#include "tasks/trace.hpp"
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace tasks {

/// A job whose messages have arrived.
struct Arrived {
    int node = 0;
    std::coroutine_handle<> job;
};

/// What an executor wants to hear, on whatever thread it happens.
struct RunnerEvents {
    std::function<void(int node)> ended;  ///< once for every node that was started
    std::function<void(Arrived)> arrived; ///< NodeRunner::resume() shall be called
};

class NodeRunner {
public:
    NodeRunner(const Plan& plan, const core::Team& team, Trace* trace, RunnerEvents events);
    NodeRunner(const NodeRunner&) = delete;
    NodeRunner& operator=(const NodeRunner&) = delete;

    void begin_step(std::int64_t step);
    /// Runs a node to its end or to its first wait. Never throws.
    void start(int node);
    /// Runs a job to its end or to its next wait. Never throws.
    void resume(Arrived arrived);
    /// @throws StepFailure on all ranks alike. Collective.
    void end_step();
    [[nodiscard]] const Plan& plan() const { return plan_; }

private:
    template <class Body>
    void guarded(const Stage& stage, LocalBlock block, Body body);
    void start_job(int node, const Stage& stage, Lane& lane);
    void abandon(int node);
    void trace(int node, double start);

    const Plan& plan_;
    Trace* trace_;
    RunnerEvents events_;
    Poison poison_;
    std::int64_t step_ = 0;
    std::vector<std::unique_ptr<Lane>> lanes_; ///< of the nodes of whole stages
    std::vector<Job> jobs_;                    ///< of the nodes that may wait
};

/// For executors that drive everything from one thread: knows what has ended, and continues jobs when asked.
class DrivenRunner {
public:
    DrivenRunner(const Plan& plan, const core::Team& team, Trace* trace);
    void begin_step(std::int64_t step);
    void start(int node) { runner_.start(node); }
    void end_step() { runner_.end_step(); }
    /// Continues the jobs whose messages have arrived.
    void advance();
    /// The same for a thread that has nothing else to do.
    void wait(core::Patience& patience);
    void wait_for(int node);
    /// The nodes that have ended since the last call.
    [[nodiscard]] std::vector<int> take_ended();
    [[nodiscard]] const Plan& plan() const { return runner_.plan(); }

private:
    void continue_arrived();

    std::mutex mutex_; // events come from the threads of a team, too
    std::vector<int> ended_;
    std::vector<char> has_ended_;
    std::deque<Arrived> arrived_;
    NodeRunner runner_;
};

} // namespace tasks

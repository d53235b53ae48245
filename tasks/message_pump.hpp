// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The only place that asks MPI whether messages have arrived, and the one token that owns MPI inside a step.
#include "core/base/patience.hpp"
#include "core/comm/communicator.hpp"
#include "tasks/alarm.hpp"
#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace tasks {

/// What became of the messages that a job waits for.
enum class Outcome { arrived, abandoned };

class MessagePump {
public:
    /// For jobs of this rank alone.
    MessagePump() = default;
    /// For jobs of several ranks, which hear of each other's failures. Collective.
    explicit MessagePump(const core::Communicator& ranks) : alarm_(std::in_place, ranks) {}

    /// Whoever calls MPI inside a step holds this (MPI_THREAD_SERIALIZED). Parallel HDF5 holds it for its duration.
    [[nodiscard]] std::mutex& token() { return token_; }
    /// Calls settled() once, when `messages` are done or after an alarm, from within a later poll() of any thread.
    void wait_for(core::Pending& messages, std::function<void(Outcome)> settled);
    /// Tests all messages unless another thread is in MPI. One atomic load if there are none. @return Whether some settled.
    bool poll();
    /// poll() for a thread that has nothing else to do until messages arrive.
    bool poll_idle(core::Patience& patience);
    [[nodiscard]] bool idle() const { return waiting_count_.load(std::memory_order_acquire) == 0; }

    /// A job has left its messages: no rank may wait for messages any more, in this step.
    void raise_alarm();
    [[nodiscard]] bool alarmed() const { return alarm_ && alarm_->raised(); }
    /// Passes on an alarm of other ranks, with no job waiting and nothing else to do.
    void listen();
    /// Ends the alarm, if any rank has raised it, on all ranks. Collective. @return Whether there was one.
    bool end_alarm();

private:
    struct Waiting {
        core::Pending* messages;
        std::function<void(Outcome)> settled;
    };
    [[nodiscard]] std::vector<Waiting> take_settled();

    std::mutex token_;
    std::mutex list_;
    std::vector<Waiting> waiting_;
    std::atomic<int> waiting_count_ = 0;
    std::optional<Alarm> alarm_;
};

} // namespace tasks

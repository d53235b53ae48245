// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The only place that asks MPI whether messages have arrived, and the one token that owns MPI inside a step.
#include "core/comm/communicator.hpp"
#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace tasks {

class MessagePump {
public:
    /// Whoever calls MPI inside a step holds this (MPI_THREAD_SERIALIZED). Parallel HDF5 holds it for its duration.
    [[nodiscard]] std::mutex& token() { return token_; }
    /// Calls arrived() once `messages` are done, from within a later poll() of any thread.
    void wait_for(core::Pending& messages, std::function<void()> arrived);
    /// Tests all messages unless another thread is in MPI. One atomic load if there are none. Returns whether some arrived.
    bool poll();
    [[nodiscard]] bool idle() const { return waiting_count_.load(std::memory_order_acquire) == 0; }

private:
    struct Waiting {
        core::Pending* messages;
        std::function<void()> arrived;
    };
    std::mutex token_;
    std::mutex list_;
    std::vector<Waiting> waiting_;
    std::atomic<int> waiting_count_ = 0;
};

} // namespace tasks

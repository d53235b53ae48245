// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tells all ranks that a job has left its messages, so that nobody waits for them: one short message, passed round the ring
// of ranks. Whoever calls it owns MPI at that moment.
#include "core/comm/communicator.hpp"
#include <array>
#include <atomic>
#include <cstddef>

namespace tasks {

class Alarm {
public:
    /// Collective.
    explicit Alarm(const core::Communicator& ranks) : ring_(ranks.duplicate()) {}
    [[nodiscard]] bool raised() const { return raised_.load(std::memory_order_relaxed); }
    /// Tells the next rank, once.
    void raise();
    /// Whether the rank before has just told this one; passes it on. Never waits.
    bool heard();
    /// Ends the alarm on all ranks, if there is one. Collective. @return Whether there was one.
    bool end();

private:
    void receive();
    [[nodiscard]] int next() const { return (ring_.rank() + 1) % ring_.size(); }
    [[nodiscard]] int previous() const { return (ring_.rank() + ring_.size() - 1) % ring_.size(); }

    core::Communicator ring_;
    std::atomic<bool> raised_ = false;
    bool received_ = false;
    std::array<std::byte, 1> message_{};
    core::Pending sent_;
};

} // namespace tasks

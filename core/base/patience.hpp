// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How to wait for what other processes do without keeping from a core whoever has work for it.
#include <chrono>

namespace core {

/// One wait: look, and as long as there is nothing, pause(). Short waits are answered at once; then the core is offered to
/// others between two looks, which are often those that are waited for; long waits sleep.
class Patience {
public:
    void pause();
    /// The wait is over; the next pause() begins another.
    void reset() { waiting_ = false; }

private:
    using Clock = std::chrono::steady_clock;
    bool waiting_ = false;
    Clock::time_point begin_;
};

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/message_pump.hpp"

#include <utility>

namespace tasks {

void MessagePump::wait_for(core::Pending& messages, std::function<void(Outcome)> settled)
{
    {
        const std::lock_guard lock(list_);
        if (!alarmed()) {
            waiting_.push_back({&messages, std::move(settled)});
            waiting_count_.store(int(waiting_.size()), std::memory_order_release);
            return;
        }
    }
    settled(Outcome::abandoned);
}

/// With the token held: the messages that are done, or all of them after an alarm.
std::vector<MessagePump::Waiting> MessagePump::take_settled()
{
    std::vector<Waiting> settled;
    const std::lock_guard lock(list_);
    std::erase_if(waiting_, [&](Waiting& w) {
        const bool now = alarmed() || w.messages->done();
        if (now) settled.push_back(std::move(w));
        return now;
    });
    waiting_count_.store(int(waiting_.size()), std::memory_order_release);
    return settled;
}

bool MessagePump::poll()
{
    if (idle()) return false;
    std::vector<Waiting> settled;
    {
        const std::unique_lock mpi(token_, std::try_to_lock);
        if (!mpi) return false;
        if (alarm_) alarm_->heard();
        settled = take_settled();
    }
    const Outcome outcome = alarmed() ? Outcome::abandoned : Outcome::arrived;
    for (const Waiting& w : settled) w.settled(outcome);
    return !settled.empty();
}

bool MessagePump::poll_idle(core::Patience& patience)
{
    const bool settled = poll();
    if (settled) patience.reset();
    else patience.pause();
    return settled;
}

void MessagePump::raise_alarm()
{
    if (!alarm_) return;
    const std::lock_guard mpi(token_);
    alarm_->raise();
}

void MessagePump::listen()
{
    if (alarm_) alarm_->heard();
}

bool MessagePump::end_alarm() { return alarm_ && alarm_->end(); }

} // namespace tasks

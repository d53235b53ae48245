// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/message_pump.hpp"

#include <utility>

namespace tasks {

void MessagePump::wait_for(core::Pending& messages, std::function<void()> arrived)
{
    const std::lock_guard lock(list_);
    waiting_.push_back({&messages, std::move(arrived)});
    waiting_count_.store(int(waiting_.size()), std::memory_order_release);
}

bool MessagePump::poll()
{
    if (idle()) return false;
    std::vector<std::function<void()>> arrived;
    {
        const std::unique_lock mpi(token_, std::try_to_lock);
        if (!mpi) return false;
        const std::lock_guard lock(list_);
        std::erase_if(waiting_, [&](Waiting& w) {
            const bool done = w.messages->done();
            if (done) arrived.push_back(std::move(w.arrived));
            return done;
        });
        waiting_count_.store(int(waiting_.size()), std::memory_order_release);
    }
    for (const auto& call : arrived) call();
    return !arrived.empty();
}

} // namespace tasks

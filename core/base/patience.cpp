// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/patience.hpp"

#include <algorithm>
#include <thread>

namespace core {
namespace {

using namespace std::chrono_literals;

// A message between two running ranks takes 1-10 us. Whoever sleeps comes back late where cores are short: sleeping after 20 us
// instead of 10 ms made runs of four ranks on two cores three times longer, and spinning ones on shared cores two to three times.
constexpr auto spinning = 20us;
constexpr auto yielding = 10ms;
constexpr auto longest_sleep = 1ms;

} // namespace

void Patience::pause()
{
    const auto now = Clock::now();
    if (!waiting_) begin_ = now;
    waiting_ = true;
    const auto waited = now - begin_;
    if (waited < spinning) return;
    if (waited < yielding) return std::this_thread::yield();
    std::this_thread::sleep_for(std::min<Clock::duration>(waited / 16, longest_sleep));
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/alarm.hpp"

#include <span>

namespace tasks {
namespace {

constexpr int tag = 1;

} // namespace

void Alarm::raise()
{
    if (ring_.size() == 1 || raised_.exchange(true)) return;
    ring_.send(message_, next(), tag, sent_);
}

bool Alarm::heard()
{
    if (ring_.size() == 1 || received_ || !ring_.has_message(previous(), tag)) return false;
    const bool news = !raised();
    receive();
    raise();
    return news;
}

bool Alarm::end()
{
    double any = raised() ? 1.0 : 0.0;
    ring_.max(std::span(&any, 1));
    if (any == 0.0) return false;
    if (!received_) receive();
    raise();
    sent_.wait();
    raised_ = received_ = false;
    return true;
}

void Alarm::receive()
{
    std::array<std::byte, 1> message{};
    core::Pending pending;
    ring_.receive(message, previous(), tag, pending);
    pending.wait();
    received_ = true;
}

} // namespace tasks

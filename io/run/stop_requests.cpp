// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/stop_requests.hpp"

#include "io/run/launch.hpp"
#include <algorithm>
#include <array>
#include <cstdint>

namespace io {

namespace {

// A signal handler can reach nothing but static data; StopRequests is the only one that reads it.
volatile std::sig_atomic_t interrupted = 0, terminated = 0, user_signal = 0;

extern "C" void note_signal(int signal)
{
    if (signal == SIGINT || signal == signal_for_interrupt) interrupted = 1;
    if (signal == SIGTERM || signal == signal_for_terminate) terminated = 1;
    if (signal == SIGUSR1) user_signal = 1;
}

void handle(int signal, void (*handler)(int), int flags)
{
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

} // namespace

std::string name_of(StopReason reason)
{
    constexpr std::array names{"nothing", "the limit of real time", "the stop file", "signal USR1", "signal TERM", "Ctrl-C"};
    return names[static_cast<std::size_t>(reason)];
}

StopRequests::StopRequests(std::filesystem::path stop_file, std::optional<double> wall_clock)
    : stop_file_(std::move(stop_file)), wall_clock_(wall_clock)
{
    interrupted = 0;
    terminated = 0;
    user_signal = 0;
    handle(SIGINT, note_signal, SA_RESTART | static_cast<int>(SA_RESETHAND));
    for (int signal : {SIGTERM, SIGUSR1, signal_for_interrupt, signal_for_terminate}) handle(signal, note_signal, SA_RESTART);
    handle(SIGXFSZ, SIG_IGN, 0); // a file that may not grow is an error of the one who writes it, not the end
}

StopRequests::~StopRequests()
{
    for (int signal : {SIGINT, SIGTERM, SIGUSR1, signal_for_interrupt, signal_for_terminate, SIGXFSZ}) handle(signal, SIG_DFL, 0);
}

StopReason StopRequests::here(int rank) const
{
    if (interrupted != 0) return StopReason::interrupted;
    if (terminated != 0) return StopReason::terminated;
    if (user_signal != 0) return StopReason::user_signal;
    if (rank != 0) return StopReason::none;
    std::error_code ignored;
    if (!stop_file_.empty() && std::filesystem::exists(stop_file_, ignored)) return StopReason::stop_file;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (wall_clock_ && passed.count() >= *wall_clock_) return StopReason::wall_clock;
    return StopReason::none;
}

StopReason StopRequests::agree(const core::Communicator& communicator) const
{
    std::array<std::int64_t, 1> reason{static_cast<std::int64_t>(here(communicator.rank()))};
    communicator.max(reason);
    return static_cast<StopReason>(reason[0]);
}

} // namespace io

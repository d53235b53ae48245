// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Requests to end a run early, agreed by all ranks: Ctrl-C, TERM, USR1, a stop file, a limit of real time.
#include "core/comm/communicator.hpp"
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace io {

/// In the order of precedence when several come at once.
enum class StopReason { none, wall_clock, stop_file, user_signal, terminated, interrupted };

/// "Ctrl-C", "the limit of real time", ...
[[nodiscard]] std::string name_of(StopReason reason);

/// Catches the signals, and what a launcher sends in their place, while it lives; one at a time in a process. A second
/// Ctrl-C ends the program at once.
class StopRequests {
public:
    /// @param stop_file   Its existence ends the run; no file if empty.
    /// @param wall_clock  Real time from now after which the run ends [s].
    explicit StopRequests(std::filesystem::path stop_file = {}, std::optional<double> wall_clock = {});
    ~StopRequests();
    StopRequests(const StopRequests&) = delete;
    StopRequests& operator=(const StopRequests&) = delete;

    /// What this rank knows. The stop file and the clock are looked at only if `rank` is 0.
    [[nodiscard]] StopReason here(int rank) const;
    /// The same answer on all ranks. Collective; to be called once a step.
    [[nodiscard]] StopReason agree(const core::Communicator& communicator) const;

private:
    std::filesystem::path stop_file_;
    std::optional<double> wall_clock_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace io

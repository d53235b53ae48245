// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The end of a program that has failed, on one rank or on all of them.
#include "core/comm/communicator.hpp"

namespace core {

/// Waits until all ranks are here, but not for longer than that [s]. @return Whether they are. The messages of `ranks` must not
/// be used again if not.
[[nodiscard]] bool all_arrive_within(const Communicator& ranks, double seconds);

/// Ends the processes of all ranks at once.
[[noreturn]] void abort_all_ranks(int exit_code);

} // namespace core

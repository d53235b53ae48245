// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What goes wrong on one rank or on all ranks becomes one message and one exit code.
#include "core/comm/communicator.hpp"
#include <functional>

namespace io {

/// Runs `body` on all ranks. If it throws everywhere, rank 0 prints each different message once; if it throws on some ranks
/// while the others go on, these are ended, too. @return its exit code, or the one that the error stands for.
[[nodiscard]] int run_together(const core::Communicator& ranks, const std::function<int()>& body);

} // namespace io

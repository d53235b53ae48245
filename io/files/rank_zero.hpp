// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Actions that only rank 0 may do, with failures that all ranks see.
#include "core/base/error.hpp"
#include "core/comm/communicator.hpp"
#include <cstring>
#include <string>

namespace io {

/// Runs `action` on rank 0. Collective. @throws E with the same text on all ranks if it throws there.
template <std::derived_from<core::Error> E, class Action>
void on_rank_zero(const core::Communicator& ranks, Action action)
{
    std::vector<std::byte> text;
    if (ranks.rank() == 0) {
        try {
            action();
        } catch (const std::exception& error) {
            text.resize(std::strlen(error.what()));
            std::memcpy(text.data(), error.what(), text.size());
        }
    }
    ranks.broadcast(text, 0);
    if (!text.empty()) throw E(std::string(reinterpret_cast<const char*>(text.data()), text.size()));
}

} // namespace io

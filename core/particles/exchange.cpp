// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/exchange.hpp"

namespace core {
namespace {

constexpr int length_tag = 101;
constexpr int data_tag = 102;

} // namespace

void Exchange::start(int ranks)
{
    outgoing.assign(std::size_t(ranks), {});
    incoming.assign(std::size_t(ranks), {});
}

void Exchange::post_lengths(const Communicator& communicator, Pending& pending)
{
    const auto ranks = std::size_t(communicator.size());
    out_length_.assign(ranks, 0);
    in_length_.assign(ranks, 0);
    for (std::size_t r = 0; r < ranks; ++r) {
        if (int(r) == communicator.rank()) continue;
        out_length_[r] = std::int64_t(outgoing[r].size());
        communicator.receive(std::as_writable_bytes(std::span(&in_length_[r], 1)), int(r), length_tag, pending);
        communicator.send(std::as_bytes(std::span(&out_length_[r], 1)), int(r), length_tag, pending);
    }
}

void Exchange::post_data(const Communicator& communicator, Pending& pending)
{
    for (std::size_t r = 0; r < outgoing.size(); ++r) {
        incoming[r].resize(std::size_t(in_length_[r]));
        if (!incoming[r].empty()) communicator.receive(incoming[r], int(r), data_tag, pending);
        if (!outgoing[r].empty() && int(r) != communicator.rank()) communicator.send(outgoing[r], int(r), data_tag, pending);
    }
}

} // namespace core

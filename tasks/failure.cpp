// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/failure.hpp"

#include "core/base/patience.hpp"

#include <array>
#include <cstring>
#include <span>
#include <utility>

namespace tasks {
namespace {

std::string sentence(const Failure& f)
{
    const std::string where = f.block < 0 ? "" : core::text(" on its block ", f.block);
    return core::text("step ", f.step, ", rank ", f.rank, ": stage '", f.stage, "' failed", where, ": ", f.text);
}

std::string message_of(const std::exception_ptr& error)
{
    try {
        std::rethrow_exception(error);
    } catch (const std::exception& e) {
        return e.what();
    } catch (...) {
        return "an exception of unknown type";
    }
}

bool is_poisoned(const std::exception_ptr& error)
{
    try {
        std::rethrow_exception(error);
    } catch (const Poisoned&) {
        return true;
    } catch (...) {
        return false;
    }
}

/// Block, length of the name, name, text.
std::vector<std::byte> packed(const Failure& f)
{
    const std::array<std::int64_t, 2> head{f.block, std::int64_t(f.stage.size())};
    const std::string words = f.stage + f.text;
    std::vector<std::byte> bytes(sizeof head + words.size());
    std::memcpy(bytes.data(), head.data(), sizeof head);
    std::memcpy(bytes.data() + sizeof head, words.data(), words.size());
    return bytes;
}

Failure unpacked(const std::vector<std::byte>& bytes, std::int64_t step, int rank)
{
    std::array<std::int64_t, 2> head{};
    std::memcpy(head.data(), bytes.data(), sizeof head);
    const std::string words(reinterpret_cast<const char*>(bytes.data()) + sizeof head, bytes.size() - sizeof head);
    const auto length = std::size_t(head[1]);
    return {words.substr(0, length), core::LocalBlock(head[0]), step, rank, words.substr(length)};
}

} // namespace

StepFailure::StepFailure(Failure failure) : core::Error(sentence(failure)), failure_(std::move(failure)) {}

bool Poison::record(const std::exception_ptr& error, const std::string& stage, core::LocalBlock block)
{
    if (is_poisoned(error)) return false;
    const std::lock_guard lock(mutex_);
    if (!first_) first_ = Failure{stage, block, step_, rank_, message_of(error)};
    set_ = true;
    return true;
}

std::optional<Failure> Poison::first() const
{
    const std::lock_guard lock(mutex_);
    return first_;
}

void Poison::clear(std::int64_t step, int rank)
{
    const std::lock_guard lock(mutex_);
    set_ = false;
    first_.reset();
    step_ = step;
    rank_ = rank;
}

std::optional<Failure> Poison::agree(const core::Communicator& ranks, const std::function<void()>& meanwhile) const
{
    if (ranks.size() == 1) return first();
    double failed = set() ? 1.0 : 0.0;
    core::Pending pending;
    ranks.start_max(std::span(&failed, 1), pending);
    for (core::Patience patience; !pending.done(); patience.pause()) meanwhile();
    if (failed == 0.0) return std::nullopt;
    const auto mine = first();
    const auto all = ranks.gather_all(mine ? packed(*mine) : std::vector<std::byte>{});
    for (std::size_t r = 0; r < all.size(); ++r)
        if (!all[r].empty()) return unpacked(all[r], step_, int(r));
    return Failure{"", -1, step_, 0, "a rank has failed and could not say why"};
}

} // namespace tasks

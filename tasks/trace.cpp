// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/trace.hpp"

#include "core/base/error.hpp"
#include "tasks/plan.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace tasks {

Trace::Trace(std::size_t capacity) : capacity_(capacity) {}

std::size_t Trace::own_buffer()
{
    const auto self = std::this_thread::get_id();
    for (std::size_t t = 0; t < most_threads; ++t) {
        auto owner = buffers_[t].owner.load(std::memory_order_relaxed);
        if (owner == self) return t;
        if (owner == std::thread::id{} && buffers_[t].owner.compare_exchange_strong(owner, self)) {
            buffers_[t].ring.reserve(capacity_);
            return t;
        }
    }
    return most_threads;
}

void Trace::add(Span span)
{
    const std::size_t thread = own_buffer();
    if (thread == most_threads) return;
    span.thread = int(thread);
    Buffer& buffer = buffers_[thread];
    if (buffer.ring.size() < capacity_) buffer.ring.push_back(span);
    else buffer.ring[buffer.count % capacity_] = span;
    ++buffer.count;
}

std::vector<Span> Trace::spans() const
{
    std::vector<Span> all;
    for (const Buffer& buffer : buffers_) all.insert(all.end(), buffer.ring.begin(), buffer.ring.end());
    std::ranges::stable_sort(all, {}, &Span::start);
    return all;
}

void Trace::write(const Plan& plan, int rank, const std::filesystem::path& file) const
{
    constexpr double microseconds = 1e6;
    auto events = nlohmann::json::array();
    for (const Span& span : spans()) {
        const Node& node = plan.nodes()[std::size_t(span.node)];
        const Stage& stage = plan.stage_of(node);
        events.push_back({{"name", stage.name},
                          {"cat", stage.lane.empty() ? "step" : stage.lane},
                          {"ph", "X"},
                          {"ts", span.start * microseconds},
                          {"dur", (span.end - span.start) * microseconds},
                          {"pid", rank},
                          {"tid", span.thread},
                          {"args", {{"step", span.step}, {"first block", node.begin}, {"last block", node.end - 1}}}});
    }
    std::ofstream stream(file);
    stream << nlohmann::json{{"displayTimeUnit", "ms"}, {"traceEvents", std::move(events)}};
    stream.close();
    core::require<core::FileError>(bool(stream), "cannot write the trace " + file.string());
}

} // namespace tasks

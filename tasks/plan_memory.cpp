// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// How much of the memory of a plan's resources is in use at the same time.
#include "tasks/plan.hpp"

#include <algorithm>
#include <map>
#include <ostream>

namespace tasks {
namespace {

/// The kept stages [first, last] between which the values of a resource matter.
struct Life {
    int first, last;
    bool carried; ///< to the next step
};

std::map<const void*, Life> lives(const Plan& plan)
{
    std::map<const void*, Life> lives;
    for (int s = 0; s < plan.stages(); ++s) {
        if (!plan.verdicts()[std::size_t(s)].kept) continue;
        for (const Touch& touch : plan.stage(s).touches) {
            auto [life, is_first] = lives.try_emplace(touch.resource, Life{s, s, touch.reads()});
            life->second.last = s;
        }
    }
    return lives;
}

} // namespace

PlanMemory memory_of(const Plan& plan, const std::vector<ResourceRecord>& resources, const std::vector<Sink>& sinks)
{
    const auto all = lives(plan);
    PlanMemory memory;
    std::vector<std::size_t> in_use(std::size_t(plan.stages()), 0);
    for (const ResourceRecord& r : resources) {
        const auto life = all.find(r.id);
        if (life == all.end() || !r.bytes) continue;
        const std::size_t bytes = r.bytes();
        memory.bytes += bytes;
        const bool kept = life->second.carried || std::ranges::any_of(sinks, [&](const Sink& sink) { return sink.resource == r.id; });
        if (kept) memory.carried += bytes;
        else
            for (int s = life->second.first; s <= life->second.last; ++s) in_use[std::size_t(s)] += bytes;
    }
    memory.most_at_once = memory.carried + (in_use.empty() ? 0 : *std::ranges::max_element(in_use));
    return memory;
}

std::ostream& operator<<(std::ostream& stream, const PlanMemory& memory)
{
    const auto per_cell = [&](std::size_t bytes) { return double(bytes) / double(std::max<std::ptrdiff_t>(memory.cells, 1)); };
    return stream << "memory of fields on this rank: " << memory.bytes << " B, " << per_cell(memory.bytes) << " B per cell; "
                  << per_cell(memory.carried) << " carried to the next step, at most " << per_cell(memory.most_at_once)
                  << " in use at once in the order of the text";
}

} // namespace tasks

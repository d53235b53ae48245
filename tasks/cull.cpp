// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Which stages a step needs: liveness of data, walked backwards from the end of the step.
#include "tasks/plan.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tasks {
namespace {

using Place = std::pair<const void*, Region>;
using Needs = std::map<Place, std::string>; ///< who needs what is there

class Culling {
public:
    Culling(const std::deque<Stage>& stages, const std::vector<std::string>& due)
        : stages_(stages), due_(due.begin(), due.end()), verdicts_(stages.size())
    {
        due_.insert("");
    }

    [[nodiscard]] bool is_due(const std::string& label) const { return due_.contains(label); }

    /// Judges all stages, given what is needed after the step. @return What is needed before it.
    Needs walk_back(Needs needs)
    {
        for (std::size_t s = stages_.size(); s-- > 0;) {
            verdicts_[s] = judge(stages_[s], needs);
            if (!verdicts_[s].kept) continue;
            for (const Touch& t : stages_[s].touches)
                if (!t.reads()) needs.erase({t.resource, t.region});
            for (const Touch& t : stages_[s].touches)
                if (t.reads()) needs.try_emplace({t.resource, t.region}, "stage '" + stages_[s].name + "' needs it");
        }
        return needs;
    }

    [[nodiscard]] bool changed_in_step(const Place& place) const
    {
        return std::ranges::any_of(stages_, [&](const Stage& stage) {
            return std::ranges::any_of(stage.touches, [&](const Touch& t) { return t.changes() && Place{t.resource, t.region} == place; });
        });
    }
    [[nodiscard]] std::vector<Verdict> verdicts() && { return std::move(verdicts_); }

private:
    [[nodiscard]] Verdict judge(const Stage& stage, const Needs& needs) const
    {
        if (stage.effect && is_due(*stage.effect)) return {true, "acts outside the graph"};
        for (const Touch& t : stage.touches) {
            const auto need = needs.find({t.resource, t.region});
            if (t.changes() && need != needs.end()) return {true, need->second};
        }
        if (stage.effect) return {false, "'" + *stage.effect + "' is not due"};
        return {false, "nobody needs what it computes"};
    }

    const std::deque<Stage>& stages_;
    std::set<std::string> due_;
    std::vector<Verdict> verdicts_;
};

} // namespace

std::vector<Verdict> cull(const std::deque<Stage>& stages, const std::vector<Sink>& sinks, const std::vector<std::string>& due)
{
    Culling culling(stages, due);
    Needs after;
    for (const Sink& sink : sinks)
        if (culling.is_due(sink.label))
            after.try_emplace({sink.resource, Region::interior},
                              sink.label.empty() ? "state of the next step" : "'" + sink.label + "' is due");
    for (bool grown = true; grown;) { // what the next step reads first must survive this one
        grown = false;
        for (const auto& [place, reason] : culling.walk_back(after))
            if (culling.changed_in_step(place)) grown |= after.try_emplace(place, "next step: " + reason).second;
    }
    return std::move(culling).verdicts();
}

} // namespace tasks

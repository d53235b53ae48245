// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Who waits for whom: the order of the text, kept only where two tasks touch the same place and one changes it.
#include "tasks/plan.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace tasks {
namespace {

/// One region of one resource in one block (-1: not divided).
using Place = std::tuple<const void*, Region, LocalBlock>;

struct History {
    int writer = -1;          ///< the last node that changed it
    std::vector<int> readers; ///< since then
};

std::vector<std::pair<LocalBlock, LocalBlock>> groups_of(const Layout& layout)
{
    std::vector<std::pair<LocalBlock, LocalBlock>> groups;
    std::ptrdiff_t cells = 0;
    for (LocalBlock b = 0, begin = 0; b < layout.blocks(); ++b) {
        cells += layout.cells[std::size_t(b)];
        if (cells < layout.cells_per_task && b + 1 < layout.blocks()) continue;
        groups.emplace_back(begin, b + 1);
        begin = b + 1;
        cells = 0;
    }
    return groups;
}

class Derivation {
public:
    std::vector<Node> nodes;

    void add(const Stage& stage, Node node)
    {
        const int self = int(nodes.size());
        auto& wait_for = node.predecessors;
        for_places(stage, node, [&](const Place& place, bool changes) {
            const History& history = histories_[place];
            if (history.writer >= 0) wait_for.push_back(history.writer);
            if (changes) wait_for.insert(wait_for.end(), history.readers.begin(), history.readers.end());
        });
        for_places(stage, node, [&](const Place& place, bool changes) {
            History& history = histories_[place];
            if (changes) history = {self, {}};
            else if (history.writer != self) history.readers.push_back(self);
        });
        std::ranges::sort(wait_for);
        wait_for.erase(std::ranges::unique(wait_for).begin(), wait_for.end());
        for (const int before : wait_for) nodes[std::size_t(before)].successors.push_back(self);
        nodes.push_back(std::move(node));
    }

private:
    template <class Visit>
    void for_places(const Stage& stage, const Node& node, Visit visit) const
    {
        for (const Touch& touch : stage.touches)
            if (!touch.divided) visit({touch.resource, touch.region, -1}, touch.changes());
            else
                for (LocalBlock b = node.begin; b < node.end; ++b) visit({touch.resource, touch.region, b}, touch.changes());
        if (stage.effect) visit({nullptr, Region::interior, -1}, true); // the outside world sees effects in the order of the text
    }

    std::map<Place, History> histories_;
};

void set_priorities(std::vector<Node>& nodes, const std::deque<Stage>& stages)
{
    for (std::size_t n = nodes.size(); n-- > 0;) {
        const bool leads_to_messages =
            std::ranges::any_of(nodes[n].successors, [&](int next) { return nodes[std::size_t(next)].priority > 0; });
        nodes[n].priority = stages[std::size_t(nodes[n].stage)].communicates() ? 2 : leads_to_messages ? 1 : 0;
    }
}

} // namespace

std::vector<Node> derive_nodes(const std::deque<Stage>& stages, const std::vector<Verdict>& verdicts, const Layout& layout)
{
    Derivation derivation;
    const auto groups = groups_of(layout);
    for (std::size_t s = 0; s < stages.size(); ++s) {
        if (!verdicts[s].kept) continue;
        if (stages[s].whole()) derivation.add(stages[s], {int(s), 0, layout.blocks(), {}, {}, 0});
        else
            for (const auto& [begin, end] : groups) derivation.add(stages[s], {int(s), begin, end, {}, {}, 0});
    }
    set_priorities(derivation.nodes, stages);
    return std::move(derivation.nodes);
}

} // namespace tasks

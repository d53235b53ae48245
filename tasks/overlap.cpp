// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/overlap.hpp"
#include <algorithm>

namespace tasks {
namespace {

/// Nodes that lie before or after those of a stage on some path; the stage's own too. Nodes are in an order that dependencies follow.
std::vector<char> ordered_with(const Plan& plan, int stage)
{
    const auto& nodes = plan.nodes();
    const auto [first, last] = plan.nodes_of(stage);
    std::vector<char> after(nodes.size(), 0), before(nodes.size(), 0);
    for (int n = first; n < last; ++n) after[std::size_t(n)] = before[std::size_t(n)] = 1;
    const auto any = [](const std::vector<int>& of, const std::vector<char>& marks) {
        return std::ranges::any_of(of, [&](int n) { return marks[std::size_t(n)] != 0; });
    };
    for (std::size_t n = 0; n < nodes.size(); ++n) after[n] |= char(any(nodes[n].predecessors, after));
    for (std::size_t n = nodes.size(); n-- > 0;) before[n] |= char(any(nodes[n].successors, before));
    for (std::size_t n = 0; n < nodes.size(); ++n) after[n] |= before[n];
    return after;
}

} // namespace

std::vector<std::string> stages_beside(const Plan& plan, std::string_view stage)
{
    int chosen = 0;
    while (chosen < plan.stages() && (plan.stage(chosen).name != stage || !plan.verdicts()[std::size_t(chosen)].kept)) ++chosen;
    std::vector<std::string> names;
    if (chosen == plan.stages()) return names;
    const std::vector<char> ordered = ordered_with(plan, chosen);
    for (int s = 0; s < plan.stages(); ++s) {
        const auto [first, last] = plan.nodes_of(s);
        const std::string& lane = plan.stage(s).lane;
        if (first == last || lane.empty() || lane == plan.stage(chosen).lane) continue;
        if (std::any_of(ordered.begin() + first, ordered.begin() + last, [](char o) { return o != 0; })) continue;
        if (std::ranges::find(names, plan.stage(s).name) == names.end()) names.push_back(plan.stage(s).name);
    }
    return names;
}

} // namespace tasks

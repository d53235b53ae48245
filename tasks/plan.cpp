// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/plan.hpp"

#include "tasks/stage_graph.hpp"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <set>

namespace tasks {

Plan::Plan(StageGraph& graph, std::vector<Verdict> verdicts)
    : graph_(&graph), verdicts_(std::move(verdicts)), nodes_(derive_nodes(graph.stages_, verdicts_, graph.layout_))
{
}

const Stage& Plan::stage(int s) const { return graph_->stages_[std::size_t(s)]; }
MessagePump& Plan::pump() const { return graph_->pump_; }
const core::Communicator& Plan::ranks() const { return graph_->ranks_; }

void Plan::renew_communicators() const { graph_->renew_communicators(); }
void Plan::give_up(int stage, Job job) const { graph_->give_up(stage, std::move(job)); }

std::pair<int, int> Plan::nodes_of(int stage) const
{
    const auto range = std::ranges::equal_range(nodes_, stage, {}, &Node::stage);
    return {int(range.begin() - nodes_.begin()), int(range.end() - nodes_.begin())};
}

namespace {

std::vector<std::string> names_of_longest_path(const Plan& plan)
{
    const auto& nodes = plan.nodes();
    std::vector<int> length(nodes.size(), 1), before(nodes.size(), -1);
    int last = -1;
    for (int n = 0; n < int(nodes.size()); ++n) {
        for (const int p : nodes[std::size_t(n)].predecessors)
            if (length[std::size_t(p)] + 1 > length[std::size_t(n)]) {
                length[std::size_t(n)] = length[std::size_t(p)] + 1;
                before[std::size_t(n)] = p;
            }
        if (last < 0 || length[std::size_t(n)] > length[std::size_t(last)]) last = n;
    }
    std::vector<std::string> names;
    for (; last >= 0; last = before[std::size_t(last)]) names.push_back(plan.stage_of(nodes[std::size_t(last)]).name);
    std::ranges::reverse(names);
    return names;
}

} // namespace

PlanReport Plan::describe() const
{
    PlanReport report;
    std::set<const void*> needed;
    for (int s = 0; s < stages(); ++s) {
        const auto [first, last] = nodes_of(s);
        auto& line =
            report.stages.emplace_back(PlanReport::StageLine{stage(s).name, stage(s).lane, verdicts_[std::size_t(s)], last - first, {}});
        std::set<int> after;
        for (int n = first; n < last; ++n)
            for (const int p : nodes_[std::size_t(n)].predecessors) after.insert(nodes_[std::size_t(p)].stage);
        for (const int p : after) line.after.push_back(stage(p).name);
        if (line.verdict.kept)
            for (const Touch& touch : stage(s).touches) needed.insert(touch.resource);
    }
    for (const auto& r : graph_->resources_) report.resources.push_back({r.name, needed.contains(r.id), r.bytes ? r.bytes() : 0});
    report.longest_path = names_of_longest_path(*this);
    report.memory = memory_of(*this, graph_->resources_, graph_->sinks_);
    report.memory.cells = std::accumulate(graph_->layout_.cells.begin(), graph_->layout_.cells.end(), std::ptrdiff_t(0));
    return report;
}

std::ostream& operator<<(std::ostream& stream, const PlanReport& report)
{
    const auto list = [&](const std::vector<std::string>& names, const char* between) {
        for (std::size_t i = 0; i < names.size(); ++i) stream << (i == 0 ? "" : between) << names[i];
    };
    stream << "stages\n";
    for (const auto& line : report.stages) {
        stream << (line.verdict.kept ? "  keep " : "  skip ") << std::setw(4) << line.tasks << "  " << line.name;
        if (!line.lane.empty()) stream << " [" << line.lane << ']';
        stream << ": " << line.verdict.reason;
        if (!line.after.empty()) stream << "; after ";
        list(line.after, ", ");
        stream << '\n';
    }
    stream << "resources\n";
    for (const auto& r : report.resources)
        stream << (r.needed ? "  keep " : "  skip ") << std::setw(12) << r.bytes << " B  " << r.name << '\n';
    stream << report.memory << '\n';
    stream << "longest path (" << report.longest_path.size() << " tasks)\n  ";
    list(report.longest_path, " > ");
    return stream << '\n';
}

} // namespace tasks

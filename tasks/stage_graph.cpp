// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/stage_graph.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

namespace tasks {

StageGraph::StageGraph(Layout layout, const core::Communicator& ranks)
    : layout_(std::move(layout)), ranks_(ranks.duplicate()), pump_(ranks_)
{
}

StageGraph::LaneScope::LaneScope(StageGraph& graph, std::string label)
    : graph_(graph), before_(std::exchange(graph.lane_, std::move(label)))
{
}

void StageGraph::remember(ResourceRecord record)
{
    const bool known = std::ranges::any_of(resources_, [&](const auto& r) { return r.id == record.id; });
    if (!known) resources_.push_back(std::move(record));
}

StageGraph::Declared StageGraph::add(Stage stage)
{
    for (const Touch& touch : stage.touches)
        if (touch.changes() && touch.region == Region::interior) halos_[touch.resource].fresh = false;
    stages_.push_back(std::move(stage));
    return {*this, stages_.size() - 1};
}

void StageGraph::check_halo(const core::FieldInfo& field, int width)
{
    core::require<core::Error>(width <= field.halo,
                               core::text("field '", field.name, "' has ", field.halo, " halo layers, but a stage reads ", width));
}

void StageGraph::refresh_halo(const void* id, FieldRef field, const std::string& name, core::HaloReach reach)
{
    core::require<core::Error>(filler_ != nullptr, "nobody fills halos: call fill_halos_with() first");
    Halo& halo = halos_[id];
    if (halo.fresh) {
        core::HaloReach& filled = stages_[halo.stage].halo_reach;
        filled = joined(filled, reach);
        return;
    }
    Stage fill;
    fill.name = "halo of " + name;
    fill.lane = lane_;
    fill.halo_of = field;
    fill.halo_reach = reach;
    fill.touches = {{id, Region::interior, Mode::read, true}, {id, Region::halo, Mode::write, true}};
    fill.job = [this, field, index = stages_.size()](Lane& lane) { return filler_->fill(lane, field, stages_[index].halo_reach); };
    halo.fresh = true;
    halo.stage = stages_.size();
    stages_.push_back(std::move(fill));
    for (const auto& declare_boundary : halo.boundary) declare_boundary();
}

Plan StageGraph::compile(const std::vector<std::string>& due)
{
    Plan plan(*this, cull(stages_, sinks_, due));
    std::set<const void*> needed;
    for (std::size_t s = 0; s < stages_.size(); ++s) {
        if (!plan.verdicts()[s].kept) continue;
        for (const Touch& touch : stages_[s].touches) needed.insert(touch.resource);
        if (stages_[s].whole() && !stages_[s].communicator) stages_[s].communicator = ranks_.duplicate();
        if (stages_[s].halo_of) filler_->prepare(*stages_[s].halo_of, stages_[s].halo_reach);
    }
    for (const auto& resource : resources_)
        if (resource.allocate && needed.contains(resource.id)) resource.allocate();
    return plan;
}

void StageGraph::renew_communicators()
{
    std::vector<std::int64_t> left(stages_.size(), 0);
    for (; renewed_ < given_up_.size(); ++renewed_) left[std::size_t(given_up_[renewed_].stage)] = 1;
    ranks_.max(std::span(left));
    for (std::size_t s = 0; s < stages_.size(); ++s)
        if (left[s] != 0) left_.push_back(std::exchange(*stages_[s].communicator, ranks_.duplicate()));
}

void StageGraph::give_up(int stage, Job job)
{
    const std::lock_guard lock(given_up_mutex_);
    given_up_.push_back({stage, std::move(job)});
}

} // namespace tasks

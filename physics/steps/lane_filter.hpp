// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A coupling filter that stages declare they work with: one for each lane that may filter while another does.
#include "physics/coupling/filter.hpp"
#include "tasks/resource.hpp"

namespace physics {

struct LaneFilter {
    LaneFilter(const std::string& name, const BlockTopology& topology, double width) : own(topology, {width}), stage_part(name, own) {}
    LaneFilter(const LaneFilter&) = delete;
    LaneFilter& operator=(const LaneFilter&) = delete;

    Filter own;
    /// To be declared as written: what it holds between two stages means nothing.
    tasks::Part<Filter> stage_part;
};

} // namespace physics

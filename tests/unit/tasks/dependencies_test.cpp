// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/plan.hpp"
#include <doctest/doctest.h>

#include <random>
#include <set>

using namespace tasks;

namespace {

constexpr int resources = 4;
const char identity[resources] = {}; // only the addresses matter

/// Stages that touch random resources in random ways; the last resource is not divided into blocks.
std::deque<Stage> random_stages(std::mt19937& pick)
{
    std::deque<Stage> stages(8);
    for (Stage& stage : stages) {
        const bool whole = pick() % 4 == 0;
        if (whole) stage.on_rank = [](Lane&) {};
        else stage.on_block = [](LocalBlock) {};
        std::set<int> used;
        for (int t = 0; t < 2; ++t) used.insert(int(pick() % resources));
        for (const int r : used) {
            const bool divided = r + 1 < resources;
            const Mode mode = divided || whole ? Mode(pick() % 3) : Mode::read;
            stage.touches.push_back({&identity[r], Region(pick() % 2), mode, divided});
        }
    }
    return stages;
}

/// Do two nodes touch the same place, at least one of them changing it?
bool conflict(const Stage& sa, const Node& a, const Stage& sb, const Node& b)
{
    for (const Touch& ta : sa.touches)
        for (const Touch& tb : sb.touches) {
            const bool same = ta.resource == tb.resource && ta.region == tb.region;
            const bool share_blocks = !ta.divided || (a.begin < b.end && b.begin < a.end);
            if (same && share_blocks && (ta.changes() || tb.changes())) return true;
        }
    return false;
}

std::vector<std::vector<bool>> ancestors(const std::vector<Node>& nodes)
{
    std::vector<std::vector<bool>> before(nodes.size(), std::vector<bool>(nodes.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n)
        for (const int p : nodes[n].predecessors) {
            before[n][std::size_t(p)] = true;
            for (std::size_t a = 0; a < n; ++a)
                if (before[std::size_t(p)][a]) before[n][a] = true;
        }
    return before;
}

} // namespace

TEST_CASE("tasks are ordered exactly where they conflict, directly or through a chain of conflicts")
{
    std::mt19937 pick(1);
    for (int trial = 0; trial < 300; ++trial) {
        const auto stages = random_stages(pick);
        const auto nodes = derive_nodes(stages, std::vector<Verdict>(stages.size(), Verdict{true, ""}), Layout{{5, 5, 5, 5}, 10});
        const auto before = ancestors(nodes);
        for (std::size_t b = 0; b < nodes.size(); ++b) {
            for (std::size_t a = 0; a < b; ++a) {
                const auto& sa = stages[std::size_t(nodes[a].stage)];
                const auto& sb = stages[std::size_t(nodes[b].stage)];
                const bool direct = std::ranges::count(nodes[b].predecessors, int(a)) > 0;
                const bool conflicting = conflict(sa, nodes[a], sb, nodes[b]);
                if (conflicting) REQUIRE(before[b][a]);
                if (direct) REQUIRE(conflicting);
            }
        }
    }
}

TEST_CASE("blocks are grouped into tasks of the asked size, and every block is in one task")
{
    std::deque<Stage> stages(1);
    stages[0].on_block = [](LocalBlock) {};
    const auto nodes = derive_nodes(stages, {{true, ""}}, Layout{{100, 10, 10, 80, 30}, 100});
    REQUIRE(nodes.size() == 3);
    CHECK(nodes[0].end == 1);
    CHECK(nodes[1].end == 4);
    CHECK(nodes[2].end == 5);
}

TEST_CASE("effects keep the order of the text although they share no data")
{
    std::deque<Stage> stages(2);
    for (Stage& stage : stages) {
        stage.on_rank = [](Lane&) {};
        stage.effect = "";
    }
    const auto nodes = derive_nodes(stages, {{true, ""}, {true, ""}}, Layout{{1}, 1});
    CHECK(nodes[1].predecessors == std::vector<int>{0});
}

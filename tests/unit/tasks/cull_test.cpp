// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"
#include <doctest/doctest.h>

#include <sstream>

using namespace tasks;

namespace {

const std::vector<core::Extents> one_block{{4, 4, 4}};

core::ScalarField field(std::string name) { return {{std::move(name), "-", 1, false}, one_block}; }

void copy(LocalBlock, core::View<const double>, core::View<double>) {}

struct NoHalo final : HaloFiller {
    Job fill(Lane&, FieldRef, core::HaloReach) override { co_return; }
};

std::vector<std::string> kept(const Plan& plan)
{
    std::vector<std::string> names;
    for (int s = 0; s < plan.stages(); ++s)
        if (plan.verdicts()[std::size_t(s)].kept) names.push_back(plan.stage(s).name);
    return names;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("a stage that no sink needs is left out together with its halo and its memory")
{
    auto u = field("u"), v = field("v"), vorticity = field("vorticity"), enstrophy = field("enstrophy");
    NoHalo filler;
    StageGraph graph(Layout{{64}, 1}, core::Communicator::self());
    graph.fill_halos_with(filler);
    graph.each_block("advance", copy, reads(u), writes(v));
    graph.each_block("curl", copy, reads(halo(v, 1)), writes(vorticity));
    graph.each_block("square", copy, reads(vorticity), writes(enstrophy));
    graph.sink(v);
    graph.sink(enstrophy, "probe");
    CHECK(kept(graph.compile()) == Names{"advance"});
    CHECK(v.allocated());
    CHECK_FALSE(vorticity.allocated());
    CHECK(kept(graph.compile({"probe"})) == Names{"advance", "halo of v", "curl", "square"});
    CHECK(enstrophy.allocated());
}

TEST_CASE("what the next step reads before it writes it is kept without being named")
{
    auto mean = field("mean"), history = field("history"), scratch = field("scratch");
    StageGraph graph(Layout{{64}, 1}, core::Communicator::self());
    graph.each_block("use history", copy, reads(history), writes(mean));
    graph.each_block("remember", copy, reads(mean), writes(history));
    graph.each_block("forget", copy, reads(mean), writes(scratch));
    graph.sink(mean);
    CHECK(kept(graph.compile()) == Names{"use history", "remember"});
}

TEST_CASE("a value that is overwritten before anyone reads it is not computed")
{
    auto a = field("a"), b = field("b");
    StageGraph graph(Layout{{64}, 1}, core::Communicator::self());
    graph.each_block("vain", copy, reads(a), writes(b));
    graph.each_block("final", copy, reads(a), writes(b));
    graph.sink(b);
    CHECK(kept(graph.compile()) == Names{"final"});
}

TEST_CASE("an effect is kept when it is due, and keeps what it reads")
{
    auto a = field("a"), b = field("b");
    StageGraph graph(Layout{{64}, 1}, core::Communicator::self());
    graph.each_block("colour", copy, reads(a), writes(b));
    graph
        .whole(
            "picture", [](Lane&, const core::ScalarField&) {}, reads(b))
        .effect("pictures");
    CHECK(kept(graph.compile()).empty());
    CHECK(kept(graph.compile({"pictures"})) == Names{"colour", "picture"});
}

TEST_CASE("a halo is filled once for all readers, as wide as the widest, and again after a change")
{
    auto u = core::ScalarField({"u", "-", 2, false}, one_block);
    auto v = field("v"), w = field("w");
    NoHalo filler;
    StageGraph graph(Layout{{64}, 1}, core::Communicator::self());
    graph.fill_halos_with(filler);
    graph.boundary(u, "walls of u", [](LocalBlock, core::View<double>) {});
    graph.each_block("narrow", copy, reads(halo(u, 1)), writes(v));
    graph.each_block("wide", copy, reads(halo(u, 2)), writes(w));
    graph.each_block(
        "change", [](LocalBlock, core::View<double>) {}, updates(u));
    graph.each_block("again", copy, reads(halo(u, 1)), writes(v));
    graph.sink(v);
    graph.sink(w);
    CHECK(kept(graph.compile()) == Names{"halo of u", "walls of u", "wide", "change", "halo of u", "walls of u", "again"});
    CHECK(graph.stages()[0].halo_reach.width == 2);
    CHECK_THROWS_AS(graph.each_block("too wide", copy, reads(halo(u, 3)), writes(v)), core::Error);
}

TEST_CASE("the plan says why, in the same words every time")
{
    auto u = field("u"), v = field("v"), w = field("w");
    StageGraph graph(Layout{{64}, 1}, core::Communicator::self());
    const auto lane = graph.lane("fluid");
    graph.each_block("advance", copy, reads(u), writes(v));
    graph.each_block("extra", copy, reads(v), writes(w));
    graph.each_block("accept", copy, reads(v), writes(u));
    graph.sink(u);
    std::ostringstream text;
    text << graph.compile().describe();
    CHECK(text.str() == "stages\n"
                        "  keep    1  advance [fluid]: stage 'accept' needs it\n"
                        "  skip    0  extra [fluid]: nobody needs what it computes\n"
                        "  keep    1  accept [fluid]: state of the next step; after advance\n"
                        "resources\n"
                        "  keep         1728 B  u\n" // 6 x 6 x 6 doubles
                        "  keep         1728 B  v\n"
                        "  skip            0 B  w\n"
                        "memory of fields on this rank: 3456 B, 54 B per cell; 27 carried to the next step, "
                        "at most 54 in use at once in the order of the text\n"
                        "longest path (2 tasks)\n"
                        "  advance > accept\n");
}

TEST_CASE("the plan knows how much memory is in use at once")
{
    auto state = field("state"), a = field("a"), b = field("b"), c = field("c");
    StageGraph graph(Layout{{64}}, core::Communicator::self());
    graph.each_block("first", copy, reads(state), writes(a));
    graph.each_block("second", copy, reads(a), writes(b));
    graph.each_block("third", copy, reads(b), writes(c));
    graph.each_block("fourth", copy, reads(c), writes(state));
    graph.sink(state);
    const PlanMemory memory = graph.compile().describe().memory;
    const std::size_t one = state.bytes();
    CHECK(one > 64 * sizeof(double)); // with halo
    CHECK(memory.bytes == 4 * one);
    CHECK(memory.carried == one);
    CHECK(memory.most_at_once == 3 * one); // each stage has two of the three others
    CHECK(memory.cells == 64);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/stage_graph.hpp"
#include <doctest/doctest.h>

using namespace tasks;
using core::View;

namespace {

using Reads = decltype(reads(std::declval<core::ScalarField&>()));
using Writes = decltype(writes(std::declval<core::ScalarField&>()));
using ReadsStep = decltype(reads(std::declval<Value<double>&>()));
using WritesStep = decltype(writes(std::declval<Value<double>&>()));

struct Look {
    void operator()(LocalBlock, View<const double>) const {}
};
struct Change {
    void operator()(LocalBlock, View<double>) const {}
};
struct LookAtAll {
    void operator()(Lane&, const core::ScalarField&, const double&) const {}
};
struct ChangeAll {
    Job operator()(Lane&, core::ScalarField&, double&) const { co_return; }
};
struct ChangeStepInBlocks {
    void operator()(LocalBlock, double&) const {}
};
struct Remember { // a kernel with a memory would depend on the order of the blocks
    int calls = 0;
    void operator()(LocalBlock, View<const double>) { ++calls; }
};

static_assert(BlockKernel<Look, Reads> && BlockKernel<Look, Writes>);
static_assert(BlockKernel<Change, Writes>);
static_assert(!BlockKernel<Change, Reads>, "what is only read cannot be written");
static_assert(!BlockKernel<Look, Reads, Writes>, "a kernel takes all that is declared");
static_assert(!BlockKernel<ChangeStepInBlocks, WritesStep>, "blocks run at once: they cannot write what they share");
static_assert(!BlockKernel<Remember, Reads>);
static_assert(WholeKernel<LookAtAll, Reads, ReadsStep> && WholeKernel<LookAtAll, Writes, WritesStep>);
static_assert(WholeKernel<ChangeAll, Writes, WritesStep>);
static_assert(!WholeKernel<ChangeAll, Reads, WritesStep> && !WholeKernel<ChangeAll, Writes, ReadsStep>);

} // namespace

TEST_CASE("holders give kernels the object that they hold")
{
    int outside = 3;
    Value<int> inside("inside", 2);
    Part<int> elsewhere("elsewhere", outside);
    PerBlock<bool> flags("flags", 2);
    StageGraph graph(Layout{{1, 1}, 1}, core::Communicator::self());
    std::get<0>(updates(inside)).whole() += 1;
    std::get<0>(updates(elsewhere)).whole() += 1;
    std::get<0>(updates(flags)).on(1) = true;
    CHECK(inside.get() == 3);
    CHECK(outside == 4);
    CHECK_FALSE(flags.on(0));
    CHECK(flags.on(1));
}

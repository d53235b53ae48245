// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=120
// The coupling filter on two ranks, against one rank, bit by bit.
#include "physics/steps/filter_job.hpp"
#include "tests/support/conduction_boxes.hpp"
#include <doctest/doctest.h>

namespace {

const core::SerialTeam serial;

/// Two filtered fields of the blocks of this rank, by global id.
std::vector<std::vector<double>> filtered(const test::ConductionProblem& p, int most_steps, const core::Communicator& communicator)
{
    physics::Filter filter(p.topology, {.bandwidth = 0.2, .most_steps = most_steps});
    const auto& layout = filter.layout();
    std::vector<core::Extents> own;
    for (int b = 0; b < layout.blocks(); ++b) own.push_back(layout.cells(b));
    core::ScalarField volume({"volume", "m3", 0, true}, own), first({"first", "1/m3", 0, true}, own), second = first;
    for (auto* f : {&volume, &first, &second}) f->allocate();
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::size_t c = 0; c < first.data(b, 0).size(); ++c) {
            volume.data(b, 0)[c] = 1e-3 * (1.0 + 0.01 * double(c % 11));
            first.data(b, 0)[c] = double(c * 7919 % 1000) / 1000.0 + layout.id(b);
            second.data(b, 0)[c] = double(c * 104729 % 1000) / 1000.0;
        }
    tasks::run(communicator, serial, [&](tasks::Lane& lane) -> tasks::Job {
        co_await physics::set_up(lane, filter, p.coefficients(), volume);
        filter.put(lane.team(), 2, [&](core::LocalBlock b, int n) { return std::as_const(n == 0 ? first : second).on(b); });
        co_await physics::run(lane, filter, 2);
    });
    filter.take(serial, 2, [&](core::LocalBlock b, int n) { return (n == 0 ? first : second).on(b); });
    std::vector<std::vector<double>> result(p.topology.cells.size());
    for (int b = 0; b < layout.blocks(); ++b) {
        auto& values = result[std::size_t(layout.id(b))] = first.data(b, 0);
        values.insert(values.end(), second.data(b, 0).begin(), second.data(b, 0).end());
    }
    return result;
}

} // namespace

TEST_CASE("the filter gives the same bits on any number of ranks")
{
    const test::BoxGrid grid{{test::uniform(12, 1.0), test::uniform(10, 1.0), test::uniform(9, 1.0)}, {3, 2, 1}, {true, false, false}};
    for (const auto& whole : {test::box_problem(grid), test::random_blocks(2, 10.0)}) {
        const auto world = core::Communicator::world().duplicate();
        std::vector<int> owner;
        for (std::size_t b = 0; b < whole.topology.cells.size(); ++b) owner.push_back(int(b % std::size_t(world.size())));
        for (const int most_steps : {0, 1000}) { // Chebyshev terms, explicit steps
            const auto alone = filtered(whole, most_steps, core::Communicator::self());
            const auto together = filtered(test::part_of(whole, owner, world.rank()), most_steps, world);
            for (std::size_t b = 0; b < owner.size(); ++b)
                if (owner[b] == world.rank()) CHECK(together[b] == alone[b]);
        }
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=120
// The solution on two ranks, against the same solve on one rank, bit by bit.
#include "core/base/error.hpp"
#include "physics/steps/pressure_solve.hpp"
#include "tests/support/conduction_jumps.hpp"
#include <cstring>
#include <doctest/doctest.h>

namespace {

const core::SerialTeam serial;

struct Solution {
    std::vector<std::vector<double>> blocks; ///< of this rank, by global id
    physics::KrylovReport report;
};

/// Source of cell n of a block: the same on any rank, with opposite signs in the halves of the block.
double source(int block, std::ptrdiff_t n, std::ptrdiff_t size)
{
    if (2 * n + 1 == size) return 0.0;
    const auto mirrored = 2 * n < size ? n : size - 1 - n;
    return (2 * n < size ? 1.0 : -1.0) * (1.0 + 0.3 * double((mirrored * 7919 + block * 104729) % 1000) / 1000.0);
}

/// Set up inside the lane that solves, or before it.
enum class SetUp { inside, outside };

Solution solve(const test::ConductionProblem& p, const core::Communicator& communicator, physics::MultigridOptions options, SetUp set_up)
{
    physics::SevenPointSolver solver(p.topology, options, communicator);
    const auto& layout = solver.layout();
    std::vector<double> right(layout.size(), 0.0), x(layout.size(), 0.0);
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size(); ++c)
            right[std::size_t(layout.origin(b) + c)] = source(layout.id(b), c, layout.cells(b).size());
    Solution s;
    const physics::KrylovOptions krylov{.most_iterations = 500, .singular = options.singular};
    if (set_up == SetUp::outside) solver.set_up(serial, p.coefficients(options.shifted));
    tasks::run(communicator, serial, [&](tasks::Lane& lane) -> tasks::Job {
        if (set_up == SetUp::inside) co_await physics::set_up(lane, solver, p.coefficients(options.shifted));
        co_await physics::solve(lane, solver, krylov, right, x, s.report);
    });
    s.blocks.resize(p.topology.cells.size());
    for (int b = 0; b < layout.blocks(); ++b)
        s.blocks[std::size_t(layout.id(b))].assign(x.begin() + layout.origin(b), x.begin() + layout.origin(b) + layout.cells(b).size());
    return s;
}

/// Solves on one rank and on all, and compares the blocks of this rank.
void check_same_bits(const test::ConductionProblem& whole, const physics::MultigridOptions& options)
{
    const auto world = core::Communicator::world().duplicate();
    std::vector<int> owner;
    for (std::size_t b = 0; b < whole.topology.cells.size(); ++b) owner.push_back(int(b % std::size_t(world.size())));
    const auto alone = solve(whole, core::Communicator::self(), options, SetUp::inside);
    for (const auto set_up : {SetUp::inside, SetUp::outside}) {
        const auto together = solve(test::part_of(whole, owner, world.rank()), world, options, set_up);
        CHECK(together.report.residuals == alone.report.residuals);
        for (std::size_t b = 0; b < owner.size(); ++b)
            if (owner[b] == world.rank()) CHECK(together.blocks[b] == alone.blocks[b]);
    }
    MESSAGE("rank " << world.rank() << ": " << alone.report.iterations << " iterations");
}

} // namespace

TEST_CASE("a box of 12 blocks has the same solution on any number of ranks, bit by bit")
{
    test::BoxGrid grid{{test::uniform(24, 1.0), test::uniform(21, 1.0), test::uniform(16, 1.0)}, {3, 2, 2}, {true, false, false}};
    const auto p = test::box_problem(grid);
    check_same_bits(p, {});
    check_same_bits(p, {.coarsest_cells = 30, .replicated_cells = 0});
    check_same_bits(p, {.coarsest_cells = 30, .replicated_cells = 200, .smoother = physics::Smoother::line});
}

TEST_CASE("lines that go on from rank to rank are solved with the same bits as on one rank")
{
    for (const bool closed : {false, true}) {
        test::BoxGrid grid{{test::uniform(16, 100.0), test::uniform(21, 1.0), test::uniform(12, 80.0)}, {2, 3, 1}, {false, closed, false}};
        check_same_bits(test::box_problem(grid), {.coarsest_cells = 30, .replicated_cells = 0});
        check_same_bits(test::box_problem(grid), {.coarsest_cells = 30, .replicated_cells = 700});
    }
}

TEST_CASE("blocks tied at random have the same solution on any number of ranks, bit by bit")
{
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const auto p = test::random_blocks(seed, 10.0);
        check_same_bits(p, {.coarsest_cells = 20, .replicated_cells = 60});
        check_same_bits(p, {.coarsest_cells = 20, .replicated_cells = 60, .shifted = true, .singular = false});
    }
}

TEST_CASE("coarse levels that follow jumping coefficients have the same bits on any number of ranks")
{
    for (const auto& pattern : {test::jump_cases[0], test::jump_cases[5]})
        check_same_bits(test::jump_problem(pattern, 14, {3, 2, 2}, 1e-5), {});
    for (unsigned seed = 1; seed <= 2; ++seed) {
        const auto p = test::random_blocks(seed, 10.0);
        const physics::MultigridOptions options{.coarsest_cells = 20, .coarsening = physics::Coarsening::coefficients};
        check_same_bits(p, options);
        check_same_bits(p, {.coarsest_cells = 20, .coarsening = physics::Coarsening::coefficients, .shifted = true, .singular = false});
    }
}

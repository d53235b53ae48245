// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The pressure of a bent channel of cells a thousand times as long as high (NUMERICS D 24): the lines across the channel go on
// through blocks, so that the solver does not see where they are cut, whichever way the blocks are counted. Slanted cells
// (D 25) cost more, within bounds.
#include "tests/support/pressure_on_grid.hpp"
#include "tests/support/stretched_channel.hpp"
#include <doctest/doctest.h>

namespace {

const core::SerialTeam serial;
constexpr int most = 20; // iterations to 1e-8 that are asked for; 5 to 14 are taken

int iterations(const test::StretchedChannel& c)
{
    test::PressureOnGrid problem(test::stretched_channel(c), c.narrows ? 1.0 : c.aspect);
    const int n = problem.solve(serial).iterations;
    MESSAGE(c.blocks.ni, " x ", c.blocks.nj, " x ", c.blocks.nk, " blocks", std::string(c.turned ? ", turned" : ""),
            std::string(c.closed_in_itself ? ", closed" : ""), ", aspect ratio ", c.aspect, std::string(c.narrows ? " at walls" : ""), ": ",
            n, " iterations");
    return n;
}

} // namespace

TEST_CASE("flat cells cost few iterations however the lines across them are cut")
{
    for (const double aspect : {10.0, 250.0, 1000.0})
        for (const int cut : {1, 2, 4, 8, 16}) CHECK(iterations({{32, 16, 8}, {2, cut, 1}, aspect}) <= most);
}

TEST_CASE("cells that narrow towards walls, too")
{
    for (const int cut : {1, 2, 4, 8}) CHECK(iterations({{32, 48, 8}, {1, cut, 1}, 1000.0, true}) <= most);
}

TEST_CASE("blocks that count their cells in other orders are no obstacle")
{
    for (const int cut : {2, 4, 8}) CHECK(iterations({{32, 16, 8}, {2, cut, 2}, 1000.0, false, true}) <= most);
}

TEST_CASE("lines without ends are solved as well")
{
    for (const int cut : {1, 2, 4}) CHECK(iterations({{32, 16, 8}, {2, cut, 1}, 1000.0, false, false, true}) <= most);
    CHECK(iterations({{32, 16, 8}, {2, 4, 1}, 1000.0, false, true, true}) <= most);
}

TEST_CASE("cells slanted by 75 degrees take at most 110 V-cycles, two in each iteration, and 150 bytes for operator and preconditioner")
{
    const double slope = std::tan(75 * std::numbers::pi / 180);
    const core::Box box{{0, 0, 0}, {1, 1, 1}, {48, 48, 48}, {1, 1, 1}, {}};
    test::PressureOnGrid problem(core::make_box(box, [=](const core::Vec3& x) { return core::Vec3(x.x() + slope * x.y(), x.y(), x.z()); }),
                                 0.3);
    const int cycles = 2 * problem.solve(serial).iterations;
    MESSAGE(cycles, " V-cycles");
    CHECK(cycles <= 110);
    const double operator_bytes = 3 * sizeof(double);
    CHECK(operator_bytes + double(problem.system().solver().multigrid().bytes()) / double(box.cells.size()) <= 150);
}

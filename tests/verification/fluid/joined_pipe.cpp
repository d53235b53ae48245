// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Two pieces of a round pipe, each of five blocks, whose sections have points of their own: curved seams between the blocks cross
// the faces beyond, and the wall has other corners (NUMERICS C1.6, U3).
#include "core/grid/touching_blocks.hpp"
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

constexpr double viscosity = 0.05, top_speed = 1;

/// A periodic pipe of diameter and length 1 with so many cells across in its first and its second half.
core::MultiBlock two_pieces(int first, int second)
{
    core::MultiBlock grid;
    for (const int n : {0, 1}) {
        const int across = n == 0 ? first : second;
        core::MultiBlock pieces = test::pipe_across(across, 1, across / 2, 1);
        for (core::Vertices& block : pieces.blocks) {
            for (Vec3& x : block.data()) x.x() = 0.5 * (x.x() + n);
            grid.blocks.push_back(std::move(block));
        }
    }
    grid.periods.push_back(Vec3::UnitX());
    core::join_touching_blocks(grid);
    return grid;
}

Vec3 poiseuille(const Vec3& x) { return {top_speed * (1 - 4 * x.tail<2>().squaredNorm()), 0, 0}; }

/// Error of the settled flow over its top speed.
double settled_error(int first, int second)
{
    physics::FluidParameters water;
    water.viscosity = viscosity;
    water.drive = physics::ConstantDrive{{16 * viscosity * top_speed, 0, 0}};
    test::FluidRun run(two_pieces(first, second), water);
    run.start(poiseuille);
    // Viscosity needs R^2 / (5.8 viscosity) = 0.9 s to settle what the grid changes.
    const double dt = 0.6 / std::max(first, second);
    for (double time = 0; time < 3; time += dt) run.step(dt);
    CHECK(run.fluid().pressure_system().report().iterations <= 20);
    CHECK(run.divergence() < 1e-4);
    return run.velocity_error(poiseuille) / top_speed;
}

} // namespace

TEST_CASE("a uniform flow stays uniform in a pipe whose sections do not match")
{
    const Vec3 uniform(0.7, -0.4, 0.5);
    physics::FluidParameters water;
    water.viscosity = 1e-3;
    water.boundaries["wall"].velocity = uniform;
    for (const auto& [first, second] : {std::pair(8, 12), std::pair(8, 16), std::pair(12, 20)}) {
        test::FluidRun run(two_pieces(first, second), water);
        REQUIRE(run.mesh().topology().joints.interfaces.size() == 10);
        run.start([&](const Vec3&) { return uniform; });
        for (int n = 0; n < 20; ++n) run.step(0.3 / second);
        const double change =
            run.largest([&](core::LocalBlock b, int i, int j, int k) { return (run.velocity(b, i, j, k) - uniform).norm(); });
        CHECK_MESSAGE(change < 1e-12, first << " and " << second << " cells across");
        CHECK(run.divergence() < 1e-13);
    }
}

TEST_CASE("Poiseuille's flow in a pipe whose sections do not match is second order")
{
    const double coarse = settled_error(8, 12), fine = settled_error(16, 24), matching = settled_error(16, 16);
    MESSAGE("errors over the top speed " << coarse << ", " << fine << ", order " << std::log2(coarse / fine) << "; matching " << matching);
    CHECK(std::log2(coarse / fine) > 1.8);
    CHECK(fine < 2 * matching); // with at least as many cells (NUMERICS D 27)
}

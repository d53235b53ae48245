// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Poiseuille's flow between walls, from an inflow to an outflow, through an interface whose points do not match.
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::BoundaryKind;

constexpr double height = 0.02, length = 0.04, mean_speed = 0.03, viscosity = 1e-4;

Vec3 poiseuille(const Vec3& x) { return {6 * mean_speed * x.y() / height * (1 - x.y() / height), 0, 0}; }

/// Error over the mean speed of the flow that has settled, with `left` and `right` cells over the height on the two sides.
double settled_error(int left, int right)
{
    const core::Box first{{0, 0, 0}, {length / 2, height, height}, {left, left, 2}, {1, 1, 1}, {}};
    const core::Box second{{length / 2, 0, 0}, {length, height, height}, {right, right, 3}, {1, 1, 1}, {}};
    core::MultiBlock grid = test::joined({first, second}, {height * Vec3::UnitZ()}, [](const Vec3& x) { return x; });
    grid.boundary_name = [](core::BlockId, core::Side s) {
        return s == core::Side::i_low ? std::string("in") : s == core::Side::i_high ? std::string("out") : std::string("wall");
    };
    physics::FluidParameters water;
    water.viscosity = viscosity;
    water.boundaries["in"] = {.kind = BoundaryKind::inflow, .profile = poiseuille};
    water.boundaries["out"] = {.kind = BoundaryKind::outflow};
    test::FluidRun run(std::move(grid), water);
    run.start(poiseuille);
    // Viscosity needs height^2 / (pi^2 viscosity) = 0.4 s to settle what the grid changes.
    const double dt = 0.5 * (length / 2 / std::max(left, right)) / (1.5 * mean_speed);
    for (double time = 0; time < 2; time += dt) run.step(dt);
    CHECK(run.fluid().pressure_system().report().iterations <= 20);
    return run.velocity_error(poiseuille) / mean_speed;
}

} // namespace

TEST_CASE("Poiseuille's flow passes an interface without matching points, to second order; through one grid it passes exactly")
{
    const double matching = settled_error(16, 16);
    CHECK(matching < 1e-9); // what solvers leave
    for (const auto& [left, right] : {std::pair(2, 3), std::pair(1, 2), std::pair(1, 4), std::pair(4, 1)}) {
        const int n = 8 / std::min(left, right);
        const double coarse = settled_error(n * left, n * right), fine = settled_error(2 * n * left, 2 * n * right);
        MESSAGE(left << ":" << right << ": errors " << coarse << ", " << fine << ", order " << std::log2(coarse / fine) << "; matching "
                     << matching);
        CHECK(std::log2(coarse / fine) > 1.8);
        // One grid of 16 cells is wrong by 1.5 / 16^2 with straight lines at its walls, and exact with parabolas (NUMERICS D 27).
        CHECK(fine < 1.5 / (16 * 16));
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Cells whose edges meet under 15 and 5 degrees (NUMERICS D 23, D 25): vortices decay as they must, and stiff viscosity does not ring.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
constexpr double turn = 2 * std::numbers::pi, viscosity = 0.05;

Vec3 vortices(const Vec3& x, double time)
{
    return std::exp(-2 * viscosity * time) * Vec3(-std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()), 0);
}

/// A periodic box of n x n cells between lines of constant y and lines that lie `slope` to 1 aslant. With a whole number for the slope
/// all that repeats along x and y repeats in it, too.
core::MultiBlock sheared(int n, int slope)
{
    const core::Box box{{0, 0, 0}, {turn, turn, turn / n}, {n, slope * n, 1}, {2, 2, 1}, {true, true, true}};
    core::MultiBlock grid = core::make_box(box, [=](const Vec3& x) { return Vec3(x.x() + slope * x.y(), x.y(), x.z()); });
    grid.periods[1] = Vec3(turn * slope, turn, 0);
    return grid;
}

physics::FluidParameters water(double nu)
{
    physics::FluidParameters p;
    p.density = 1;
    p.viscosity = nu;
    return p;
}

struct Outcome {
    double error;   ///< root mean square, of the velocity at time 1
    int iterations; ///< most for a pressure
};

Outcome decay(int n, int slope)
{
    test::FluidRun run(sheared(n, slope), water(viscosity));
    run.start([](const Vec3& x) { return vortices(x, 0); },
              [](const Vec3& x) { return -0.25 * (std::cos(2 * x.x()) + std::cos(2 * x.y())); });
    run.fluid().state().clock.steps_since_jump = 2;
    const int steps = n * slope / 2; // a step crosses less than a cell along either line
    Outcome outcome{};
    for (int s = 0; s < steps; ++s) {
        run.step(1.0 / steps);
        outcome.iterations = std::max(outcome.iterations, run.fluid().pressure_system().report().iterations);
    }
    outcome.error = run.velocity_error([&](const Vec3& x) { return vortices(x, run.time()); });
    MESSAGE("slope ", slope, ", ", n, " cells, ", steps, " steps: error ", outcome.error, ", at most ", outcome.iterations, " iterations");
    return outcome;
}

void check_decay(int coarse_cells, int fine_cells, int slope)
{
    const Outcome coarse = decay(coarse_cells, slope), fine = decay(fine_cells, slope);
    const double order = std::log(coarse.error / fine.error) / std::log(double(fine_cells) / coarse_cells);
    MESSAGE("slope ", slope, ": order ", order);
    CHECK(order > 1.5);          // NUMERICS D 25
    CHECK(fine.iterations < 40); // a solver that stalls is stopped after 200
}

/// Largest speed after some steps of a viscosity `stiff` times what an explicit step could take, over that at the start.
double left_by_viscosity(int n, int slope, double stiff)
{
    const double dt = 0.1, height = turn / (n * slope), start = 0.01;
    test::FluidRun run(sheared(n, slope), water(stiff * height * height / dt));
    run.start([&](const Vec3& x) { return Vec3(start * vortices(x, 0)); });
    const auto speed = [&](core::LocalBlock b, int i, int j, int k) { return run.velocity(b, i, j, k).norm(); };
    double most = 0, last = start;
    for (int s = 0; s < 4; ++s) {
        run.step(dt);
        most = std::max(most, run.largest(speed) / last);
        last = std::max(run.largest(speed), 1e-5 * start); // below lies what the solver leaves of the pressure
    }
    CHECK(most <= 1);                                          // cross terms that lag would ring and grow
    CHECK(run.fluid().viscosity_system()->iterations() < 300); // with V-cycles 130 to 220, without up to 1310
    MESSAGE("slope ", slope, ", ", n, " cells, ", stiff, ": left ", run.largest(speed) / start, ", products of the last step ",
            run.fluid().viscosity_system()->iterations());
    return run.largest(speed) / start;
}

} // namespace

TEST_CASE("vortices decay at order 1.5 or better on cells whose edges meet under 14 degrees") { check_decay(16, 32, 4); }

TEST_CASE("vortices decay at order 1.5 or better on cells whose edges meet under 5 degrees") { check_decay(24, 48, 12); }

TEST_CASE("viscosity 1e5 times stiffer than explicit steps allow does not ring on skewed cells")
{
    // Viscosity leaves 1 / (1 + 2 nu dt) of the vortices in a step, here a fiftieth to a five-hundredth, in each of four. What is
    // left then is what the pressure of the start, of some u^2, still pushes: u dt / (2 nu dt) = 1e-5 of u, and some such.
    CHECK(left_by_viscosity(32, 4, 1e5) < 1e-4);
    CHECK(left_by_viscosity(64, 4, 1e5) < 1e-4);
    CHECK(left_by_viscosity(32, 12, 1e5) < 1e-4);
}

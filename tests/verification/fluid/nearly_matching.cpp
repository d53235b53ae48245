// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Sides with 100 cells against 101, whose sub-faces are slivers next to whole faces (NUMERICS D 26, D 27).
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
constexpr double viscosity = 0.05;

Vec3 vortices(const Vec3& x, double time)
{
    return std::exp(-2 * viscosity * time) * Vec3(-std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()), 0);
}

/// Root mean square error of the velocity after decaying for a while between halves of 100 and `second` cells along their sides.
double error(int second)
{
    physics::FluidParameters water;
    water.density = 1;
    water.viscosity = viscosity;
    test::FluidRun run(test::wavy_halves({{16, 100, 1}, {16, second, 1}}, 0.0, 0), water);
    run.start([](const Vec3& x) { return vortices(x, 0); },
              [](const Vec3& x) { return -0.25 * (std::cos(2 * x.x()) + std::cos(2 * x.y())); });
    run.fluid().state().clock.steps_since_jump = 2;
    int iterations = 0;
    for (int s = 0; s < 40; ++s) {
        run.step(0.025);
        iterations = std::max(iterations, run.fluid().pressure_system().report().iterations);
    }
    const double e = run.velocity_error([&](const Vec3& x) { return vortices(x, run.time()); });
    MESSAGE("100 cells against ", second, ": error ", e, ", at most ", iterations, " iterations");
    CHECK(iterations <= 20);
    CHECK(run.divergence() < 1e-5); // the solver's tolerance refers to the throughput of a cell, about the largest flux
    return e;
}

} // namespace

TEST_CASE("100 cells against 101 are as good as against 100")
{
    const double matching = error(100), sliver = error(101);
    CHECK(sliver < 2 * matching); // NUMERICS D 27
}

TEST_CASE("so are 100 cells against 99 and 102")
{
    const double matching = error(100);
    CHECK(error(99) < 2 * matching);
    CHECK(error(102) < 2 * matching);
}

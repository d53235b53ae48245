// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Stiff and extreme cases of the fluid alone (NUMERICS D18, D23, D28).
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>
#include <numbers>

namespace {

constexpr double turn = 2 * std::numbers::pi;

core::Vec3 vortices(const core::Vec3& x) { return {-std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()), 0}; }
double vortex_pressure(const core::Vec3& x) { return -0.25 * (std::cos(2 * x.x()) + std::cos(2 * x.y())); }

physics::FluidParameters water(double viscosity)
{
    physics::FluidParameters p;
    p.density = 1;
    p.viscosity = viscosity;
    p.tolerances.pressure = 1e-11;
    p.tolerances.viscosity = 1e-11;
    return p;
}

core::MultiBlock wavy_box(int n, int thick)
{
    const core::Box box{{0, 0, 0}, {turn, turn, turn * thick / n}, {n, n, thick}, {2, 1, 1}, {true, true, true}};
    return core::make_box(box, [](const core::Vec3& x) { return test::wavy(x, 0.2, 0); });
}

/// Two plates at y = 0 and 1.
core::MultiBlock channel(int n) { return core::make_box({{0, 0, 0}, {1, 1, 1}, {2, n, 2}, {1, 1, 1}, {true, false, true}}); }

} // namespace

TEST_CASE("an impulsive reversal does not ring, however stiff the viscosity")
{
    physics::FluidParameters p = water(1.0);
    p.drive = physics::ReversingDrive{core::Vec3(1, 0, 0), 0.0};
    test::FluidRun run(channel(32), p);
    const double dt = 10.0 / (32 * 32); // nu dt / h^2 = 10
    auto& clock = run.fluid().state().clock;
    const auto at_wall = [&] { return run.velocity(0, 0, 0, 0).x(); };
    for (int n = 0; n < 60; ++n) run.step(dt);
    const double before = at_wall();
    CHECK(before > 0);
    CHECK(physics::turn_if_due(p.drive, 1.0, clock.time, clock.drive));
    clock.steps_since_jump = 0;
    double last = before;
    for (int n = 0; n < 60; ++n) {
        run.step(dt);
        // Velocity at the wall falls without coming back up; the allowance is the solver's.
        CHECK(at_wall() <= last + 1e-9 * before);
        last = at_wall();
    }
    // Of the slowest wave of the change, twice the flow, exp(-pi^2 nu t) is left: 0.3 %.
    CHECK(std::abs(last / before + 1) < 2 * std::exp(-std::numbers::pi * std::numbers::pi * 60 * dt));
}

TEST_CASE("viscosity 1e5 times stiffer than explicit steps allow leads to rest at once")
{
    const double dt = 0.1, h = turn / 16, viscosity = 1e5 * h * h / dt;
    test::FluidRun run(wavy_box(16, 1), water(viscosity));
    run.start(vortices);
    const auto speed = [&](core::LocalBlock b, int i, int j, int k) { return run.velocity(b, i, j, k).norm(); };
    run.step(dt);
    // Backward Euler leaves 1 / (1 + 2 nu dt) = 3e-5 of the vortices, the wavy grid some of its own order.
    CHECK(run.largest(speed) < 1e-4);
    for (int n = 0; n < 10; ++n) run.step(dt);
    CHECK(run.largest(speed) < 1e-4);
    MESSAGE("velocity left ", run.largest(speed), ", iterations ", run.fluid().viscosity_system()->iterations());
}

TEST_CASE("a box one cell thick gives the same as a thick one")
{
    test::FluidRun thin(wavy_box(16, 1), water(0.02)), thick(wavy_box(16, 4), water(0.02));
    for (auto* run : {&thin, &thick}) {
        run->start(vortices, vortex_pressure);
        for (int n = 0; n < 10; ++n) run->step(0.1);
    }
    const double difference = thick.largest(
        [&](core::LocalBlock b, int i, int j, int k) { return (thick.velocity(b, i, j, k) - thin.velocity(b, i, j, 0)).norm(); });
    // Both solve their pressure to 1e-11 of the throughput.
    CHECK(difference < 1e-9);
}

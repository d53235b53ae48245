// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// What flows in over a laminar profile, and boundaries whose velocity changes in time, against exact solutions.
#include "tests/support/fluid_run.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::BoundaryKind, physics::TableCourse;
using std::numbers::pi;

physics::FluidParameters fluid(double viscosity)
{
    physics::FluidParameters p;
    p.viscosity = viscosity;
    p.tolerances = {.pressure = 1e-11, .viscosity = 1e-11};
    return p;
}

core::MultiBlock channel(int cells, double length)
{
    return core::make_box({{0, 0, 0}, {length, 1, 0.5}, {int(length * cells / 2), cells, 2}, {2, 1, 1}, {false, false, true}});
}

} // namespace

TEST_CASE("a laminar inflow passes a channel unchanged, to second order")
{
    const auto error = [](int cells) {
        auto water = fluid(0.05);
        water.boundaries["x_low"] = {.kind = BoundaryKind::inflow, .velocity = {1, 0, 0}, .laminar = true};
        water.boundaries["x_high"] = {.kind = BoundaryKind::outflow};
        test::FluidRun run(channel(cells, 4), water);
        const auto poiseuille = [](const Vec3& x) { return Vec3(6 * x.y() * (1 - x.y()), 0, 0); };
        run.start(poiseuille);
        for (int n = 0; n < 12 * cells; ++n) run.step(0.6 / cells); // 7.2 h / U; viscosity needs h^2 / (pi^2 nu) = 2
        return run.velocity_error(poiseuille);
    };
    const double coarse = error(8), fine = error(16);
    MESSAGE("error over the mean speed, 8 and 16 cells: ", coarse, ", ", fine);
    CHECK(fine < 0.01);
    CHECK(std::log2(coarse / fine) > 1.8);
}

TEST_CASE("a plug follows the table of its inflow at the end of every step, and the pressure what that needs")
{
    auto water = fluid(0); // where the table bends, viscosity would see the old pressure's velocity beside the new inflow
    water.boundaries["x_low"] = {
        .kind = BoundaryKind::inflow,
        .velocity = {2, 0, 0},
        .course = TableCourse({{0, 0.1}, {0.5, 0.1}, {1.5, 0.4}}, TableCourse::Between::linear, TableCourse::Beyond::hold)};
    water.boundaries["x_high"] = {.kind = BoundaryKind::pressure};
    for (const char* side : {"y_low", "y_high"}) water.boundaries[side] = {.kind = BoundaryKind::slip};
    test::FluidRun run(channel(8, 4), water);
    run.start([](const Vec3&) { return Vec3(0.2, 0, 0); });
    double slow = 0;
    while (run.time() < 2 - 1e-9) {
        run.step(0.0625);
        const double t = run.time(), speed = 2 * (t < 0.5 ? 0.1 : t < 1.5 ? 0.1 + 0.3 * (t - 0.5) : 0.4);
        slow = std::max(slow, run.velocity_error([&](const Vec3&) { return Vec3(speed, 0, 0); }));
        const double gain = t > 0.5 + 1e-9 && t < 1.5 + 1e-9 ? 0.6 : 0.0; // [m/s2]
        const double error = run.pressure_error([&](const Vec3& x) { return 1000 * gain * (4 - x.x()); });
        CHECK(error < 1e-6 * 2400); // that of the projection, 1e-11 of the flux, over the step; the largest pressure is 2400 Pa
    }
    CHECK(slow < 1e-9); // likewise
}

namespace {

/// Error of the flow above a wall that moves to and fro, over the wall's largest speed; depth of penetration 1.
double stokes_error(int cells, int steps)
{
    const double omega = 2.0, top = 8.0;
    auto water = fluid(1.0); // sqrt(2 nu / omega) = 1
    water.boundaries["y_low"] = {.velocity = {1, 0, 0}, .course = physics::HarmonicCourse{0, 1, omega, 0}};
    test::FluidRun run(core::make_box({{0, 0, 0}, {1, top, 1}, {2, cells, 1}, {1, 2, 1}, {true, false, true}}), water);
    const auto exact = [&](double t) { return [=](const Vec3& x) { return Vec3(std::exp(-x.y()) * std::cos(omega * t - x.y()), 0, 0); }; };
    run.start(exact(0));
    run.fluid().state().clock.steps_since_jump = 2; // the exact start is no jump
    for (int n = 0; n < steps; ++n) run.step(2 * pi / omega / steps);
    const double error = run.velocity_error(exact(run.time())) * std::sqrt(top);
    MESSAGE(cells, " cells, ", steps, " steps: ", error);
    return error;
}

} // namespace

TEST_CASE("the flow above a wall that moves to and fro is that of Stokes' second problem, to second order")
{
    // exp(-8) = 3e-4 of the wall's motion is left at the top, which is at rest: far below these errors.
    const double coarse = stokes_error(32, 16), fine = stokes_error(64, 32);
    CHECK(fine < 0.01);
    CHECK(std::log2(coarse / fine) > 1.8);
}

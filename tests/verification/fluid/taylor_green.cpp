// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Decaying vortices on a wavy grid (NUMERICS C1.2): order in space and time, divergence, momentum.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

constexpr double viscosity = 0.05;

core::Vec3 velocity(const core::Vec3& x, double time)
{
    const double f = std::exp(-2 * viscosity * time);
    return {-std::cos(x.x()) * std::sin(x.y()) * f, std::sin(x.x()) * std::cos(x.y()) * f, 0};
}

/// Of unit density.
double pressure(const core::Vec3& x, double time)
{
    return -0.25 * (std::cos(2 * x.x()) + std::cos(2 * x.y())) * std::exp(-4 * viscosity * time);
}

struct Errors {
    double velocity, pressure;
};

physics::FluidParameters unit_water()
{
    physics::FluidParameters water;
    water.density = 1;
    water.viscosity = viscosity;
    return water;
}

core::MultiBlock wavy_box(int n, int blocks, int thick, double amplitude)
{
    const double length = 2 * std::numbers::pi;
    const core::Box box{{0, 0, 0}, {length, length, length}, {n, n, thick}, {blocks, blocks, 1}, {true, true, true}};
    return core::make_box(box, [=](const core::Vec3& x) { return test::wavy(x, amplitude, 0); });
}

/// Errors at time 1 with n x n cells.
Errors errors(int n, int steps, physics::AdvectionScheme scheme)
{
    physics::FluidParameters water = unit_water();
    water.advection = scheme;
    test::FluidRun run(wavy_box(n, 2, 1, 0.25), water);
    run.start([](const core::Vec3& x) { return velocity(x, 0); }, [](const core::Vec3& x) { return pressure(x, 0); });
    run.fluid().state().clock.steps_since_jump = 2;
    const double dt = 1.0 / steps;
    for (int s = 0; s < steps; ++s) run.step(dt);
    // The solver's tolerance refers to the throughput of a cell, which is about the largest flux.
    CHECK(run.divergence() < 1e-5);
    const Errors e{run.velocity_error([&](const core::Vec3& x) { return velocity(x, run.time()); }),
                   run.pressure_error([&](const core::Vec3& x) { return pressure(x, run.time() - dt / 2); })};
    MESSAGE(n, " cells, ", steps, " steps: velocity ", e.velocity, ", pressure ", e.pressure, ", pressure iterations ",
            run.fluid().pressure_system().report().iterations);
    return e;
}

} // namespace

TEST_CASE("decaying vortices on a wavy grid are second order when grid and step are refined together")
{
    for (const auto scheme : {physics::AdvectionScheme::lcsi, physics::AdvectionScheme::finite_volume}) {
        const Errors coarse = errors(16, 8, scheme), middle = errors(32, 16, scheme), fine = errors(64, 32, scheme);
        CHECK(std::log2(middle.velocity / fine.velocity) > 1.8);
        CHECK(std::log2(middle.pressure / fine.pressure) > 1.5);
        CHECK(coarse.velocity > middle.velocity);
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A uniform flow stays uniform on any grid (NUMERICS C0 U3), whatever the step.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

const core::Vec3 uniform(0.7, -0.4, 0.5);

physics::FluidParameters water_of(double viscosity)
{
    physics::FluidParameters water;
    water.viscosity = viscosity;
    return water;
}

/// Largest change of velocity after 20 steps in which the flow crosses `cells` cells each.
double change(core::MultiBlock grid, const physics::FluidParameters& water, double cells)
{
    test::FluidRun run(std::move(grid), water);
    run.start([&](const core::Vec3&) { return uniform; });
    const auto rates = physics::transport_rates(run.mesh().geometry(0), run.fluid().state().velocity.on(0));
    for (int n = 0; n < 20; ++n) run.step(cells / rates.displacement);
    // Round-off of some 1e3 operations in each of 20 steps.
    CHECK(run.divergence() < 1e-13);
    return run.largest([&](core::LocalBlock b, int i, int j, int k) { return (run.velocity(b, i, j, k) - uniform).norm(); });
}

core::MultiBlock wavy_box(double amplitude)
{
    const double length = 2 * std::numbers::pi;
    const core::Box box{{0, 0, 0}, {length, length, length}, {12, 12, 8}, {2, 1, 2}, {true, true, true}};
    return core::make_box(box, [=](const core::Vec3& x) { return test::wavy(x, amplitude, 1); });
}

} // namespace

TEST_CASE("a uniform flow stays uniform on a wavy box")
{
    CHECK(change(wavy_box(0.3), water_of(1e-3), 0.8) < 1e-12);
    CHECK(change(wavy_box(0.3), water_of(0), 0.3) < 1e-12);
    physics::FluidParameters by_volumes = water_of(1e-3);
    by_volumes.advection = physics::AdvectionScheme::finite_volume;
    CHECK(change(wavy_box(0.3), by_volumes, 0.3) < 1e-12);
    by_volumes.viscosity = 0;
    CHECK(change(wavy_box(0.3), by_volumes, 0.3) < 1e-12);
}

TEST_CASE("a uniform flow stays uniform on the pipe, singular edges and skewed cells included")
{
    physics::FluidParameters water = water_of(1e-3);
    water.boundaries["wall"].velocity = uniform;
    CHECK(change(test::pipe_across(12, 1, 8, 2), water, 0.5) < 1e-12);
    water.advection = physics::AdvectionScheme::finite_volume;
    CHECK(change(test::pipe_across(12, 1, 8, 2), water, 0.2) < 1e-12);
}

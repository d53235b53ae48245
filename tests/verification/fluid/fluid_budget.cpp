// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Momentum is accounted for, and steady flow in the pipe has the friction it must have (NUMERICS C1.6).
#include "tests/support/fluid_run.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

namespace {

/// Swirl and cross flow in a pipe of radius 1 and length 2, zero on its wall.
core::Vec3 swirl(const core::Vec3& x)
{
    const double fade = 1 - x.tail<2>().squaredNorm();
    return fade * core::Vec3(1 + 0.3 * std::sin(std::numbers::pi * x.x()), -x.z() + 0.2 * std::cos(std::numbers::pi * x.x()), x.y());
}

} // namespace

TEST_CASE("drive, walls and the defect of advection explain all change of momentum")
{
    physics::FluidParameters water;
    water.density = 800;
    water.viscosity = 0.01;
    water.drive = physics::ConstantDrive{core::Vec3(0.5, 0, 0)};
    test::FluidRun run(test::pipe_across(12, 2.0, 16, 2), water);
    run.start(swirl);
    const double momentum = run.mesh().total_volume();
    for (int n = 0; n < 10; ++n) {
        run.step(0.05);
        const auto budget = run.budget();
        // Sums over 3e3 cells in double precision, and what the solver leaves of the viscous change.
        CHECK(budget.defect().norm() < 1e-12 * momentum + 1e-8 * budget.viscosity.norm());
        CHECK(budget.drive.x() == test::relative(0.05 * 0.5 * momentum));
        // The interpolation is of third order: at 12 cells across it loses less than half a percent of momentum in a step.
        CHECK(budget.advection.norm() < 5e-3 * momentum);
        CHECK(budget.viscosity.x() < 0);
    }
    MESSAGE("advection defect of the last step over momentum: ", run.budget().advection.norm() / momentum);
}

TEST_CASE("Poiseuille flow on 16 cells across has its flow rate within 1 % and friction equals the drive")
{
    physics::FluidParameters water;
    water.viscosity = 1;
    water.tolerances.viscosity = 1e-12; // of terms that are 1e5 times the drive, as the step is 1e4 diffusion times
    water.drive = physics::ConstantDrive{core::Vec3(8e-6, 0, 0)}; // slow: no way is longer than a cell
    test::FluidRun run(test::pipe_across(16, 2.0, 2, 1), water);
    for (int n = 0; n < 3; ++n) {
        run.fluid().state().clock.steps_since_jump = 0; // implicit throughout: straight to the steady state
        run.step(1e4);
    }
    // Mean velocity g R^2 / (8 nu) = 1e-6; the polygon of the wall has 32 sides.
    const double mean = run.mean([&](core::LocalBlock b, int i, int j, int k) { return run.velocity(b, i, j, k).x(); });
    CHECK(mean == test::relative(1e-6).epsilon(0.01));
    const auto budget = run.budget();
    // Friction is what goes through the walls; see the solver's tolerance above.
    CHECK(budget.viscosity.x() == test::relative(-budget.drive.x()).epsilon(1e-6));
    MESSAGE("mean velocity ", mean, ", iterations ", run.fluid().viscosity_system()->iterations());
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Momentum is accounted for, and steady flow in the pipe has the friction it must have (NUMERICS C1.6).
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
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
    for (const auto scheme : {physics::AdvectionScheme::lcsi, physics::AdvectionScheme::finite_volume}) {
        physics::FluidParameters water;
        water.advection = scheme;
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
            // The interpolation is of third order: at 12 cells across it loses less than half a percent of momentum in a step. Of fluxes
            // that enter one cell and leave another the round-off of those sums remains.
            CHECK(budget.advection.norm() < (run.fluid().by_finite_volumes() ? 1e-14 : 5e-3) * momentum);
            CHECK(budget.viscosity.x() < 0);
        }
        MESSAGE("advection defect of the last step over momentum: ", run.budget().advection.norm() / momentum);
    }
}

TEST_CASE("finite volumes keep the momentum of a periodic box to round-off, and what flows through boundaries is accounted for")
{
    physics::FluidParameters water;
    water.density = 1;
    water.viscosity = 1e-3;
    water.advection = physics::AdvectionScheme::finite_volume;
    const double side = 2 * std::numbers::pi;
    core::Box box{{0, 0, 0}, {side, side, side}, {16, 12, 12}, {2, 1, 2}, {true, true, true}};
    const auto flow = [](const core::Vec3& x) {
        return core::Vec3(1 + std::sin(x.y()), std::sin(x.x() + x.z()), 0.5 + std::cos(x.x()) * std::sin(x.y()));
    };
    test::FluidRun closed(core::make_box(box, [](const core::Vec3& x) { return x; }), water);
    closed.start(flow);
    const double amount = closed.mesh().total_volume();
    closed.step(0.1); // the first projection removes the divergence of the start
    const core::Vec3 before = closed.budget().after;
    for (int n = 0; n < 20; ++n) closed.step(0.1);
    // Round-off of 20 sums over 2,304 cells; on a uniform grid pressure gradients sum to zero, and viscous fluxes cancel.
    CHECK((closed.budget().after - before).norm() < 1e-12 * amount);

    box.periodic[0] = false;
    water.boundaries["x_low"] = {.kind = physics::BoundaryKind::inflow, .velocity = {1, 0.2, 0}};
    water.boundaries["x_high"] = {.kind = physics::BoundaryKind::outflow};
    test::FluidRun open(core::make_box(box, [](const core::Vec3& x) { return x; }), water);
    open.start([](const core::Vec3& x) { return core::Vec3(1 + 0.3 * std::sin(x.x()) * std::sin(x.y()), 0.2, 0.1 * std::cos(x.y())); });
    for (int n = 0; n < 10; ++n) {
        open.step(0.1);
        CHECK(open.budget().advection.norm() < 1e-13 * amount);
        CHECK(open.budget().through.norm() > 1e-5 * amount); // what is accounted for is not nothing
    }
}

TEST_CASE("finite volumes keep momentum through sides whose points do not match")
{
    physics::FluidParameters water;
    water.viscosity = 1e-3;
    water.advection = physics::AdvectionScheme::finite_volume;
    test::FluidRun run(test::wavy_halves({{5, 8, 8}, {6, 12, 20}}, 0.3, 37), water);
    run.start([](const core::Vec3& x) { return core::Vec3(1 + std::sin(x.y()), std::sin(x.x() + x.z()), std::cos(x.x())); });
    for (int n = 0; n < 10; ++n) {
        run.step(0.3 / run.outflow_rate());
        CHECK(run.budget().advection.norm() < 1e-14 * run.mesh().total_volume()); // round-off of a sum over 1,760 cells
    }
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

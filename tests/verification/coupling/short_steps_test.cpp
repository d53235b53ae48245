// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Steps shorter than contacts ask for are as short as the scene says.
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

CoupledBox box_of(double dt)
{
    CoupledBox box;
    box.cells = {4, 6, 4};
    box.gravity = {0, -9.81, 0};
    box.dt = dt;
    return box;
}

/// The sub-step that contacts ask for [s].
double contact_step()
{
    CoupledRun run(box_of(1e-3), 1);
    run.start();
    run.step();
    return run.world().clock().dt / run.world().sub_steps();
}

} // namespace

TEST_CASE("a time step far below the sub-step of contacts is made as it is, with fluid and without")
{
    const double dt = contact_step() / 70;
    for (const bool wet : {true, false}) {
        io::Scene scene = scene_of(box_of(dt), 1);
        if (!wet) scene.fluid.reset();
        CoupledRun run(scene);
        run.place({Vec3(8e-3, 12e-3, 8e-3)});
        if (wet) run.start();
        else run.go_on();
        for (int n = 0; n < 20; ++n) run.step();
        // From rest drag is a millionth of the weight after so short a time: half of the fluid's density is added mass at s = 2.
        const double fall = wet ? 9.81 * 1.0 / 2.5 : 9.81;
        std::printf("%s: dt %.3g s, time %.6g of %.6g s, speed %.6f of g t\n", wet ? "in water" : "dry", run.world().clock().dt,
                    run.world().time(), 20 * dt, -run.grains().velocity_of(0).y() / (fall * 20 * dt));
        CHECK(run.world().sub_steps() == 1);
        CHECK(run.world().time() == test::relative(20 * dt).epsilon(1e-12));
        // The fluid that the grain moves about itself as the filter shows it: C_m C of 3 %.
        CHECK(-run.grains().velocity_of(0).y() == test::relative(fall * 20 * dt).epsilon(wet ? 0.05 : 1e-9));
    }
}

TEST_CASE("a grain bounces off the floor with the restitution of its contact, the closer the shorter the time step")
{
    const double sub_step = contact_step();
    for (const double share : {1.0, 1.0 / 7}) {
        io::Scene scene = scene_of(box_of(share * sub_step), 1);
        scene.fluid.reset();
        scene.gravity.reset();
        CoupledRun run(scene);
        run.place({Vec3(8e-3, 1.001e-3, 8e-3)});
        run.grains().velocity[1][0] = -0.1;
        run.go_on();
        for (int n = 0; n < 400; ++n) run.step();
        std::printf("step %.3g of what contacts ask for: speed after over before %.9f\n", share, run.grains().velocity_of(0).y() / 0.1);
        // Thirty steps in a contact, whose first and last are cut: up to a thirtieth.
        CHECK(run.grains().velocity_of(0).y() == test::relative(0.1 * scene.contact->restitution).epsilon(share / 30));
    }
}

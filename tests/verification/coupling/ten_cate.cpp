// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=900 long
// A sphere of 15 mm settles in a box of silicone oil, in cells smaller than itself, as ten Cate and others (2002) measured.
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

TEST_CASE("the largest speed of ten Cate's sphere is found within 10 %")
{
    struct Case {
        double density, viscosity, speed; ///< dynamic viscosity [Pa s]
    };
    for (const Case& c : {Case{970, .373, .035986}, {965, .212, .05718}, {962, .113, .087269}, {960, .058, .12224}})
        for (const auto own : {io::Switch::off, io::Switch::on}) {
            CoupledBox box;
            box.size = {0.1, 0.16, 0.1};
            box.cells = {10, 16, 10};
            box.diameter = 15e-3;
            box.viscosity = c.viscosity / c.density;
            box.gravity = {0, -9.81, 0};
            box.drag = io::DragLaw::schiller_naumann;
            box.own_disturbance = own;
            box.mode = io::CouplingMode::automatic;
            box.dt = 5e-3;
            box.stiffness = 1e4;
            io::Scene scene = scene_of(box, 1);
            scene.fluid->material.density = c.density;
            scene.particles.front().density = 1120;
            CoupledRun run(scene);
            run.place({Vec3(0.05, 0.1275, 0.05)}); // its lowest point is 120 mm above the floor
            run.start();
            double fastest = 0;
            while (run.grains().position_of(0).y() > 0.025 && run.world().time() < 6) {
                run.step();
                fastest = std::max(fastest, -run.grains().velocity_of(0).y());
            }
            std::printf("ten Cate, Re %.1f, own disturbance %s: %.5f m/s, measured %.5f, off by %.1f %%\n",
                        c.density * c.speed * box.diameter / c.viscosity, own == io::Switch::on ? "off the slip" : "left", fastest, c.speed,
                        100 * (fastest / c.speed - 1));
            if (own == io::Switch::on) CHECK(std::abs(fastest / c.speed - 1) < 0.10); // the gate
        }
}

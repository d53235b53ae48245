// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A bed in a column comes to rest, and carries the pressure drop that its drag and weight ask for.
#include "tests/support/column.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>

using physics::Mode;
using testing::Column;
using testing::ColumnScene;

namespace {

ColumnScene bed(double ratio, bool air, Mode mode)
{
    ColumnScene scene;
    scene.density_ratio = ratio;
    scene.mode = mode;
    if (air) {
        scene.density = 1.2;
        scene.viscosity = 1.8e-5;
        scene.added_mass = 0.0;
    }
    return scene;
}

} // namespace

TEST_CASE("a bed comes to rest where naive lagging would amplify")
{
    for (Mode mode : {Mode::pipelined, Mode::coarse, Mode::concurrent, Mode::iterated}) {
        for (double ratio : {1.05, 2.0, 2.65, 1000.0}) {
            const ColumnScene scene = bed(ratio, ratio > 100.0, mode);
            Column column(scene);
            for (int n = 0; n < 1000; ++n) column.step();
            std::printf("%-9s s %.2f A %.2f: rms velocity %.1e m/s after 1 s, closure %.0e\n", physics::name(mode), ratio,
                        physics::added_mass_amplification(0.4, ratio, scene.added_mass), column.rms_velocity(), column.closure());
            // A thousandth of the velocity a grain gains in one step of free fall. `concurrent` takes grains for what contacts
            // did to them a step ago: where added mass would amplify, a bed never quite rests, and that mode is not made.
            const double solid = 1.0 - scene.phi, loading = ratio * solid / scene.phi;
            const bool made =
                holds(mode, {column.stiffness(), loading, physics::added_mass_amplification(scene.phi, ratio, scene.added_mass), solid});
            CHECK(column.rms_velocity() < (made ? 1e-3 : 1.0) * scene.gravity * scene.dt);
            CHECK(column.closure() < 1e-12);
        }
    }
}

TEST_CASE("a bed of 50 um grains with stiff drag stays bounded from below to far above fluidisation")
{
    for (Mode mode : {Mode::pipelined, Mode::coarse, Mode::concurrent, Mode::iterated}) {
        for (bool air : {false, true}) {
            for (double lift : {0.5, 1.5, 3.0}) {
                ColumnScene scene = bed(air ? 1000.0 : 2.65, air, mode);
                scene.diameter = 50e-6;
                scene.contact_time = 5.2e-5;
                scene.cells = 50;
                const double slowest = air ? 1.161e-3 : 1.60e-5; // superficial velocity of minimum fluidisation, Ergun at phi 0.4 [m/s]
                const double flow = lift * slowest;
                scene.flow = [flow](double t) { return flow * std::min(1.0, t / 0.02); };
                Column column(scene);
                double fastest = 0.0, drop = 0.0;
                for (int n = 0; n < 100; ++n) {
                    column.step();
                    fastest = std::max(fastest, column.rms_velocity());
                    if (n >= 50) drop += column.drop_over_weight() / 50.0;
                }
                std::printf("%-9s %-5s %.1f u_mf b %.2g: fastest rms %.1e m/s, last %.1e, mean drop/weight %.3f, closure %.0e\n",
                            physics::name(mode), air ? "air" : "water", lift, column.stiffness(), fastest, column.rms_velocity(), drop,
                            column.closure());
                // The settling velocity of one grain bounds what drag lets a grain do: 2.2 mm/s in water, 0.09 m/s in air.
                CHECK(fastest < (air ? 0.09 : 2.2e-3) + 10.0 * flow);
                CHECK(column.closure() < 1e-12);
            }
        }
    }
}

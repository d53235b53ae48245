// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Where the pressure lag amplifies (A > 1), naive exchange blows up and ours does not.
#include "tests/support/one_cell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>

using physics::Mode;
using testing::CellScene;
using testing::OneCell;

namespace {

/// Fastest grain when grains use pressure and fluid acceleration of the last step and fluid merely fills what they leave.
double naive_fastest(const CellScene& scene, double phi, int steps)
{
    const double c = 1.0 - phi, dt = scene.dt, added = scene.added_mass * c, solid = scene.density_ratio * c;
    const double drag = scene.stiffness * solid;
    double u = 0.0, v = 0.0, force = 0.0, acceleration = 0.0, fastest = 0.0;
    for (int n = 0; n < steps && fastest < 1e3; ++n) {
        const double push =
            solid * v + dt * c * (force - (scene.density_ratio - 1.0) * scene.gravity) + drag * u + added * (v + dt * acceleration);
        const double v_new = push / (solid + drag + added);
        const double u_new = -c / phi * v_new;
        const double change = (u_new - u) / dt;
        force = change + added / phi * (change - (v_new - v) / dt) - drag / dt / phi * (v_new - u_new);
        acceleration = change;
        u = u_new;
        v = v_new;
        fastest = std::max(fastest, std::abs(v));
    }
    return fastest;
}

} // namespace

TEST_CASE("naive lagging blows up where A > 1; pipelined, coarse and iterated stay bounded")
{
    for (double ratio : {1.1, 2.0, 2.65}) {
        CellScene scene;
        scene.density_ratio = ratio;
        scene.stiffness = 0.02;
        const double phi = 0.4;
        scene.loading = ratio * (1.0 - phi) / phi;
        const double growth = physics::added_mass_amplification(phi, ratio, scene.added_mass);
        const double naive = naive_fastest(scene, phi, 400);
        std::printf("s %.2f A %.2f: naive %.1e m/s", ratio, growth, naive);
        CHECK(growth > 1.0);
        CHECK(naive >= 1e3);
        for (Mode mode : {Mode::pipelined, Mode::coarse, Mode::iterated}) {
            scene.mode = mode;
            OneCell cell(scene);
            double fastest = 0.0;
            for (int n = 0; n < 10000; ++n) {
                cell.step();
                fastest = std::max(fastest, cell.fastest());
            }
            std::printf(", %s %.3f", physics::name(mode), fastest);
            // Terminal slip without lag: (s-1) g times the drag time dt / b, shared by both phases.
            CHECK(fastest < (ratio - 1.0) * scene.gravity * scene.dt / scene.stiffness);
        }
        std::printf("\n");
    }
}

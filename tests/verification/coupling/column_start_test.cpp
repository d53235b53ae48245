// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A suspension released from rest in a closed column starts with the acceleration of the confined mixture and stays calm.
#include "tests/support/column.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>

using physics::Mode;
using testing::Bottom;
using testing::Column;
using testing::ColumnScene;

namespace {

/// -(s-1) g / [s + (1-phi)/phi + C_m (1-phi)/phi^2 + C_m/phi]: both phases under one pressure gradient, no drag.
double exact_acceleration(const ColumnScene& scene)
{
    const double s = scene.density_ratio, phi = scene.phi, c = scene.added_mass;
    return -(s - 1.0) * scene.gravity / (s + (1.0 - phi) / phi + c * (1.0 - phi) / (phi * phi) + c / phi);
}

ColumnScene suspension(double ratio, double phi, double added_mass, Mode mode)
{
    ColumnScene scene;
    scene.density_ratio = ratio;
    scene.phi = phi;
    scene.added_mass = added_mass;
    scene.mode = mode;
    scene.bottom = Bottom::periodic;
    scene.layers = 80; // two grains in a cell: an even suspension
    return scene;
}

} // namespace

TEST_CASE("a closed suspension accelerates within 2 % of the exact mixture from the tenth step on")
{
    for (Mode mode : {Mode::pipelined, Mode::coarse, Mode::concurrent, Mode::iterated}) {
        for (double ratio : {1.1, 1.5, 2.0, 2.65}) {
            for (double phi : {0.4, 0.6, 0.9}) {
                for (double added_mass : {0.0, 0.5}) {
                    ColumnScene scene = suspension(ratio, phi, added_mass, mode);
                    scene.drag = 0.0;
                    Column column(scene);
                    double worst = 0.0;
                    for (int n = 1; n <= 20; ++n) {
                        column.step();
                        const double exact = exact_acceleration(scene) * column.time();
                        if (n >= 10) worst = std::max(worst, std::abs(column.mean_velocity() / exact - 1.0));
                    }
                    std::printf("%-9s s %.2f phi %.1f C_m %.1f  A %.2f  error %.4f\n", physics::name(mode), ratio, phi, added_mass,
                                physics::added_mass_amplification(phi, ratio, added_mass), worst);
                    CHECK(worst < 0.02);
                }
            }
        }
    }
}

TEST_CASE("a sinking suspension does not grow over 1e4 steps")
{
    for (Mode mode : {Mode::pipelined, Mode::coarse, Mode::concurrent}) {
        for (double ratio : {1.1, 2.65}) {
            Column column(suspension(ratio, 0.4, 0.5, mode));
            for (int n = 0; n < 1000; ++n) column.step();
            const double early = column.rms_velocity();
            for (int n = 0; n < 9000; ++n) column.step();
            std::printf("%-9s s %.2f b %.2g: rms velocity %.6e after 1e3, %.6e after 1e4 steps, closure %.0e\n", physics::name(mode), ratio,
                        column.stiffness(), early, column.rms_velocity(), column.closure());
            // Hindered settling is steady; the grains' spacing may wander by a per mille.
            CHECK(std::abs(column.rms_velocity() / early - 1.0) < 0.01);
            CHECK(column.closure() < 1e-12); // round-off of 1e4 steps relative to the weight's impulse
        }
    }
}

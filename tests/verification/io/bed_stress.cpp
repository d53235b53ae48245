// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What is measured over a bed: grains that move, and the stress of a steady flow, which carries what the drive gives the fluid above.
// ctest: timeout=60
#include "io/run/bed_metrics.hpp"
#include "io/run/momentum_ledger.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <doctest/doctest.h>

namespace {

constexpr double gradient = 2.0; // [Pa/m]

/// So heavy that nothing moves them, in hardly any gravity, under a thick fluid that slips above.
test::CoupledRun bed()
{
    return test::CoupledRun(
        test::scene_from_text("name: bed\ngrid: { box: { size: [16 mm, 20 mm, 12 mm], cells: [8, 20, 6] }, periodic: [x, z] }\nfluid:\n"
                              "  oil: { density: 1000 kg/m3, viscosity: 2e-3 m2/s }\n  boundaries: [{ at: y_high, kind: symmetry }]\n"
                              "  drive: { axis: x, pressure_gradient: 2 Pa/m }\ngravity: { direction: -y, magnitude: 1e-15 m/s2 }\n"
                              "particles:\n  - { name: S, count: 120, diameter: 2 mm, density: 1e15 kg/m3, initial: { arrangement: dense, "
                              "low: [0 mm, 1 mm, 0 mm], "
                              "high: [16 mm, 5.5 mm, 12 mm] } }\ncontact: { law: linear, stiffness: 5 kN/m, walls: primitive }\n"
                              "output: { grains: [transport] }\nrun: { until: 2 s, time_step: 20 ms }\n"));
}

} // namespace

TEST_CASE("the stress on a bed is the drive times the height of the fluid above it, once the flow is steady")
{
    test::CoupledRun run = bed();
    io::World& world = run.world();
    run.start();
    io::MomentumLedger ledger(world);
    const io::MetricGroup stress = io::bed_stress_metrics(world, ledger), moving = io::bed_metrics(world);
    for (int n = 0; n < 600; ++n) {
        run.step();
        ledger.update();
    }
    const double top = moving.values()[3], area = 16e-3 * 12e-3;
    const io::BedLayers layers = io::BedLayering(world).of(world);
    double above = 0; // of the layer that the top cuts, its share
    for (std::size_t n = 0; n < layers.solid.size(); ++n)
        above += layers.solid[n] * std::clamp(double(n + 1) - (top - layers.lowest) / layers.thickness, 0.0, 1.0);
    const double expected = gradient * (20e-3 - top - above / area);
    CHECK(top > 4e-3); // grains lie up to 6 mm
    CHECK(top < 6.5e-3);
    // The flow is steady to exp(-12 s x (pi / 2)^2 x 2e-3 m2/s / (15 mm)^2), the pressure to 1e-8.
    CHECK(stress.values()[0] == test::relative(expected).epsilon(1e-6));
    CHECK(std::abs(stress.values()[2]) < 0.02 * expected); // across the flow an uneven bed of 48 diameters squared gives a little
}

TEST_CASE("transport is the volume of grains times their velocity over the area of the bed, down to where they stand")
{
    test::CoupledRun run = bed();
    io::World& world = run.world();
    core::ParticleSet& p = run.grains();
    const double area = 16e-3 * 12e-3, volume = std::numbers::pi / 6 * 8e-9;
    double expected = 0;
    for (int i = 0; i < p.owned; ++i)
        if (const auto n = std::size_t(i); p.position[1][n] + world.grains()->domain().origin[1] > 3e-3) {
            p.velocity[0][n] = 0.25;
            expected += volume * 0.25 / area;
        }
    const auto values = io::bed_metrics(world).values();
    CHECK(values[0] == test::relative(expected).epsilon(1e-12));
    CHECK(values[1] == 0.0);
    CHECK(values[2] == 0.0);
    // Those whose centres lie above 3 mm reach down to 2 mm, in layers of 0.4 mm; above, the layer ends with the bed.
    CHECK(values[3] - values[4] == doctest::Approx(2e-3).scale(1).epsilon(0.6e-3));
}

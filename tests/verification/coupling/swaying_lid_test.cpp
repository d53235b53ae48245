// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Grains below a lid that moves to and fro: friction on walls is that of their speed at the start and at the end of each step.
#include "io/run/momentum_ledger.hpp"
#include "io/run/world.hpp"
#include "tests/support/scene_from_text.hpp"
#include <cstdio>
#include <doctest/doctest.h>

namespace {

io::Scene scene(const std::string& mode)
{
    return test::scene_from_text(R"(name: lid
grid: { box: { size: [16 mm, 16 mm, 16 mm], cells: [8, 8, 8], blocks: [1, 2, 1] }, periodic: [x, z] }
fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-4 m2/s }
  boundaries: [{ at: y_high, velocity: [0.2 m/s, 0 m/s, 0 m/s], over_time: { frequency: 20 Hz } }]
gravity: { direction: -y }
particles: [{ name: grains, count: 60, diameter: 2 mm, density: 2000 kg/m3 }]
contact: { stiffness: 500 N/m }
coupling: { mode: )" + mode + R"( }
run: { settle: 50 ms, until: 1 s, time_step: 1 ms }
)");
}

} // namespace

TEST_CASE("momentum closes below a lid that moves to and fro, in every mode")
{
    for (const char* mode : {"pipelined", "coarse", "concurrent", "iterated"}) {
        io::World world(scene(mode), core::Communicator::self());
        world.settle(core::SerialTeam());
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        io::MomentumLedger books(world);
        double defect = 0, friction = 0;
        for (int step = 0; step < 60; ++step) {
            world.step(*executor);
            books.update();
            defect = std::max(defect, books.defect());
            friction = std::max(friction, books.impulses().wall_friction.norm());
        }
        std::printf("%-10s unexplained %.1e, friction up to %.1e N s\n", mode, defect, friction);
        CHECK(defect < 1e-9); // the solver's share of the viscous change, 1e-8 of it
        CHECK(friction > 0);
    }
}

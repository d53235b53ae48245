// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// All forces at once on grains of two sizes: whatever acts, the fluid loses what the grains gain.
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

io::Scene scene_with_all_forces(io::CouplingMode mode, io::DragLaw drag)
{
    CoupledBox box;
    box.gravity = {0, -9.81, 0};
    box.pressure_gradient = 3000;
    box.periodic = {io::Axis::x, io::Axis::z};
    box.mode = mode;
    box.drag = drag;
    io::Scene scene = scene_of(box, 60);
    scene.particles.push_back(scene.particles.front());
    scene.particles.back().name = "large";
    scene.particles.back().count = 20;
    scene.particles.back().diameter = 3e-3;
    io::Coupling& c = *scene.coupling;
    c.added_mass = io::AddedMass::zuber;
    for (io::Switch* s : {&c.size_mixture, &c.lift, &c.shear_lift, &c.torque, &c.history, &c.own_disturbance}) *s = io::Switch::on;
    return scene;
}

} // namespace

TEST_CASE("with all forces on a mixture of sizes momentum is exchanged to round-off in every mode")
{
    using enum io::DragLaw;
    const io::DragLaw laws[] = {beetstra, rong, tenneti, gidaspow};
    for (std::size_t n = 0; n < every_mode.size(); ++n) {
        CoupledRun run(scene_with_all_forces(every_mode[n], laws[n]));
        run.start();
        io::MomentumLedger books(run.world());
        double exchange = 0, total = 0;
        for (int step = 0; step < 40; ++step) {
            run.step();
            books.update();
            exchange = std::max(exchange, books.exchange_defect());
            total = std::max(total, books.defect());
        }
        std::printf("%s: exchange %.1e, total %.1e, fastest grain %.3f m/s\n", run.world().mode_reason().substr(0, 10).c_str(), exchange,
                    total, run.grain_deviation());
        CHECK(exchange < 1e-12);
        CHECK(total < 1e-8);                // as without the forces: the tolerance of the pressure
        CHECK(run.grain_deviation() < 1.0); // 40 ms at 3 m/s2 and sinking: nothing has gone wild
    }
}

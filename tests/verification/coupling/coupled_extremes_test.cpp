// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Suspensions in thick liquids, light grains, thin cells, large grains: speeds stay within what gravity and drag allow.
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

struct Case {
    const char* name;
    double density_ratio, viscosity, dt;
    std::array<int, 3> cells;
    int count;
    double fastest; ///< settling velocity of one grain alone, or what buoyancy gives in the time [m/s]
};

} // namespace

TEST_CASE("settling suspensions stay within the speed of one grain alone")
{
    // Terminal velocities of one grain by Schiller-Naumann, by Stokes in the thick liquids.
    for (const Case& c :
         {Case{"water, s 2", 2.0, 1e-6, 1e-3, {8, 12, 8}, 250, 0.21}, Case{"water, s 1.05", 1.05, 1e-6, 1e-3, {8, 12, 8}, 250, 0.03},
          Case{"water, s 0.5", 0.5, 1e-6, 1e-3, {8, 12, 8}, 250, 0.15}, Case{"water, s 8", 8.0, 1e-6, 1e-3, {8, 12, 8}, 250, 0.65},
          Case{"oil, s 2", 2.0, 1e-4, 1e-3, {8, 12, 8}, 250, 0.022}, Case{"glycerine, s 2", 2.0, 1e-3, 1e-3, {8, 12, 8}, 250, 0.0022},
          Case{"glycerine, s 2, 5 ms", 2.0, 1e-3, 5e-3, {8, 12, 8}, 250, 0.0022},
          Case{"thin cells", 2.0, 1e-6, 1e-3, {8, 48, 8}, 250, 0.21}, Case{"large grains", 2.0, 1e-6, 1e-3, {16, 24, 16}, 250, 0.21},
          Case{"tiny steps", 2.0, 1e-6, 5e-5, {8, 12, 8}, 250, 0.21}}) {
        CoupledBox box;
        box.density_ratio = c.density_ratio;
        box.viscosity = c.viscosity;
        box.dt = c.dt;
        box.cells = c.cells;
        box.gravity = {0, -9.81, 0};
        box.periodic = {io::Axis::x, io::Axis::z};
        box.mode = io::CouplingMode::automatic;
        CoupledRun run(box, c.count);
        run.start();
        io::MomentumLedger books(run.world());
        double grains = 0, fluid = 0, exchange = 0, defect = 0;
        for (int n = 0; n < 100; ++n) {
            run.step();
            books.update();
            grains = std::max(grains, run.grain_deviation());
            fluid = std::max(fluid, run.fluid_deviation());
            exchange = std::max(exchange, books.exchange_defect());
            defect = std::max(defect, books.defect());
        }
        std::printf("%-22s b %8.2g: grains %.2e of %.1e, fluid %.2e m/s; exchange %.0e, momentum %.0e\n", c.name,
                    run.world().coupling()->stability(c.dt).stiffness, grains, c.fastest, fluid, exchange, defect);
        CHECK(grains < 1.2 * c.fastest); // in a suspension some are swept along
        CHECK(fluid < c.fastest);
        CHECK(exchange < 1e-12);
        CHECK(defect < 1e-8); // friction is measured at the walls: the solver of the viscosity leaves 1e-8 of the viscous change
    }
}

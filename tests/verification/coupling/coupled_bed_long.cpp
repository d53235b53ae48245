// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=3000 long
// Beds that must stay at rest for a long time: ten seconds in a box, and one in the periodic pipe.
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

void check_rest(CoupledRun& run, int steps, const char* name)
{
    run.stop_grains();
    run.start();
    const double weight = 9.81 * run.grains().mass[0] / 2;
    double fastest = 0;
    for (int n = 1; n <= steps; ++n) {
        run.step();
        if (n >= steps / 10) fastest = std::max(fastest, run.fluid_deviation());
        if (n % (steps / 10) == 0)
            std::printf("%s, step %d: fluid %.1e, grains %.1e m/s, net force %.1e of the weight\n", name, n, run.fluid_deviation(),
                        run.grain_deviation(), run.net_force_over_weight(weight));
    }
    // Water at rest: the gates of the coupling's design.
    CHECK(fastest < 1e-5);
    CHECK(run.fluid_deviation() < 1e-6);
    CHECK(run.net_force_over_weight(weight) < 1e-6);
}

} // namespace

TEST_CASE("a bed in a box rests for ten thousand steps")
{
    CoupledBox box;
    box.gravity = {0, -9.81, 0};
    box.settle = 1.0;
    CoupledRun run(box, 250);
    check_rest(run, 10000, "box");
}

TEST_CASE("a bed in the periodic pipe rests")
{
    CoupledBox box;
    box.gravity = {0, -9.81, 0};
    io::Scene scene = scene_of(box, 500);
    scene.grid.box.reset();
    scene.grid.pipe.emplace();
    scene.grid.pipe->diameter = 30e-3;
    scene.grid.pipe->length = 30e-3;
    scene.grid.pipe->cells = io::PipeCells{12, 12};
    scene.grid.pipe->blocks_along = 2;
    scene.grid.periodic = {io::Axis::axial};
    scene.run.settle = 1.0;
    scene.resolve();
    CoupledRun run(scene);
    check_rest(run, 1000, "pipe");
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A random bed at rest in still fluid: the fluid stays still, and all it does to a grain is buoyancy (NUMERICS C5.8).
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

struct Bed {
    const char* fluid;
    double density, viscosity; ///< [kg/m3], kinematic [m2/s]
    io::CouplingMode mode;
    double stiffness = 1000; ///< [N/m]
};

io::Scene scene_of(const Bed& bed)
{
    CoupledBox box;
    box.gravity = {0, -9.81, 0};
    box.settle = 0.3;
    box.mode = bed.mode;
    box.stiffness = bed.stiffness;
    io::Scene scene = test::scene_of(box, 180);
    scene.fluid->material = {bed.fluid, bed.density, bed.viscosity};
    scene.contact->rolling_friction = scene.contact->twisting_friction = 0.1; // else some grain rolls to and fro in its nest for long
    return scene;
}

/// Largest of what the fluid does to a grain beside buoyancy, over the weight less buoyancy.
double force_beside_buoyancy(CoupledRun& run, double fluid_density)
{
    const core::ParticleSet& grains = run.grains();
    const auto impulses = run.world().coupling()->exchange().impulses(grains);
    double largest = 0;
    for (int g = 0; g < grains.owned; ++g) {
        const double mass = grains.mass[std::size_t(g)];
        const double buoyed = mass - fluid_density * physics::GrainExchange::volume(grains, g);
        const Vec3 weight(0, -9.81 * buoyed, 0);
        largest = std::max(largest, (impulses[std::size_t(g)].applied / run.world().clock().dt - weight).norm() / weight.norm());
    }
    return largest;
}

void say(const Bed& bed, CoupledRun& run)
{
    std::printf("%s, %s: fluid %.1e, grains %.1e m/s, force beside buoyancy %.1e of the weight\n", bed.fluid,
                run.world().mode_reason().substr(0, 10).c_str(), run.fluid_deviation(), run.grain_deviation(),
                force_beside_buoyancy(run, bed.density));
}

} // namespace

TEST_CASE("a random bed at rest feels its weight less its buoyancy in still fluid, which stays still, in every mode")
{
    using enum io::CouplingMode;
    const Bed beds[] = {{"water", 1000, 1e-6, pipelined}, {"water", 1000, 1e-6, coarse}, {"water", 1000, 1e-6, iterated},
                        {"air", 1.2, 1.5e-5, pipelined},  {"air", 1.2, 1.5e-5, coarse},  {"air", 1.2, 1.5e-5, concurrent},
                        {"air", 1.2, 1.5e-5, iterated}};
    for (const Bed& bed : beds) {
        CoupledRun run(scene_of(bed));
        run.start();
        for (int n = 0; n < 100; ++n) run.step();
        say(bed, run);
        CHECK(run.world().mode_reason().ends_with("as the scene asks"));
        CHECK(run.fluid_deviation() < 1e-10); // the gate of C5.8
        CHECK(force_beside_buoyancy(run, bed.density) < 1e-9);
    }
}

TEST_CASE("a bed that was shaken comes to rest like that again in one pass")
{
    // Oil, for water would swirl above the bed for minutes: it loses a tenth of its velocity in a second. Springs that
    // hold against the drag of oil, so that one pass suffices.
    using enum io::CouplingMode;
    for (const io::CouplingMode mode : {pipelined, coarse}) {
        const Bed bed{"oil", 1000, 1e-4, mode, 8000};
        CoupledRun run(scene_of(bed));
        run.start();
        for (double& v : run.grains().velocity[1]) v += 0.01;
        double fastest = 0;
        for (int n = 0; n < 600; ++n) {
            run.step();
            fastest = std::max(fastest, run.fluid_deviation());
        }
        say(bed, run);
        CHECK(run.world().mode_reason().ends_with("as the scene asks"));
        CHECK(fastest > 1e-4); // the test of the test
        CHECK(run.fluid_deviation() < 1e-10);
        CHECK(force_beside_buoyancy(run, bed.density) < 1e-9);
    }
}

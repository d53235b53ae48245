// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// At which fraction water carries the alumina spheres of Ferreira and others (2023), evenly spread, by each drag law (NUMERICS C5.4). What
// waves of loose and dense spheres make of that is in configs/fluidised_column.
// ctest: timeout=300
#include "tests/support/coupled_run.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

constexpr double diameter = 3.087e-3, density = 3585.9, water = 997, viscosity = 8.379e-7, inflow = 0.157033, gravity = 9.81;
const double volume = std::numbers::pi / 6 * diameter * diameter * diameter;
constexpr int below = 6, layers = 18, along = 30; // cells, each with two spheres

struct Lifted {
    double force = 0;    ///< on a sphere in the middle of the bed, over its weight less buoyancy
    double fraction = 0; ///< of water, from the pressure gradient
};

io::Scene column(io::DragLaw drag, double edge)
{
    CoupledBox box;
    box.size = edge * Vec3(4, along, 4);
    box.cells = {4, along, 4};
    box.periodic = {io::Axis::x, io::Axis::z};
    box.diameter = diameter;
    box.gravity = {0, -gravity, 0};
    box.drag = drag;
    box.dt = 5e-4;
    io::Scene scene = scene_of(box, 1);
    scene.fluid->material = {"water", water, viscosity};
    io::Boundary in, out;
    in.at = "y_low";
    in.kind = io::BoundaryKind::inflow;
    in.velocity = Vec3(0, inflow, 0);
    out.at = "y_high";
    out.kind = io::BoundaryKind::outflow;
    scene.fluid->boundaries = {in, out};
    scene.particles[0].density = density;
    return scene;
}

/// Spheres at rest on a body-centred lattice that leaves `fraction` to the water, which comes in below.
Lifted lifted(io::DragLaw drag, double fraction)
{
    const double edge = std::cbrt(2 * volume / (1 - fraction));
    CoupledRun run(column(drag, edge));
    std::vector<Vec3> places;
    core::for_each({0, below, 0}, {4, below + layers, 4}, [&](int i, int j, int k) {
        for (const double at : {0.25, 0.75}) places.push_back(edge * (Vec3(i, j, k) + Vec3::Constant(at)));
    });
    run.place(places);
    run.start(Vec3(0, inflow, 0));
    for (int n = 0; n < 15; ++n) { // held until the start is over: water that starts at once kicks them
        run.step();
        if (n < 10) run.stop_grains();
    }
    Lifted found;
    const auto impulses = run.world().coupling()->exchange().impulses(run.grains());
    int count = 0;
    const double low = (below + 6) * edge, high = (below + layers - 6) * edge, weight = (density - water) * volume * gravity;
    for (int g = 0; g < run.grains().owned; ++g) {
        const double y = run.grains().position_of(g).y();
        if (y < low || y > high) continue;
        found.force += impulses[std::size_t(g)].applied.y() / run.world().clock().dt / weight;
        ++count;
    }
    found.force /= count;
    const auto& pressure = run.world().fluid()->state().pressure.on(0);
    const double drop = pressure(1, below + 6, 1) - pressure(1, below + layers - 6, 1);
    found.fraction = 1 - drop / ((layers - 12) * edge * (density - water) * gravity);
    return found;
}

} // namespace

TEST_CASE("water carries evenly spread spheres at the fraction that each drag law asks for, and its pressure their weight")
{
    struct Law {
        const char* name;
        io::DragLaw drag;
        double expected;
    };
    // By hand, from drag = phi (rho_p - rho) V g at the slip U / phi. After Richardson and Zaki, as measured: 0.622.
    for (const Law& law : {Law{"Wen, Yu", io::DragLaw::wen_yu, 0.640}, Law{"Di Felice", io::DragLaw::smooth, 0.661}}) {
        const double low = law.expected - 0.01, high = law.expected + 0.01;
        const Lifted dense = lifted(law.drag, low), loose = lifted(law.drag, high);
        CHECK(dense.force > 0);
        CHECK(loose.force < 0);
        const double share = dense.force / (dense.force - loose.force), found = low + share * (high - low);
        const double carried = dense.fraction + share * (loose.fraction - dense.fraction);
        std::printf("%s: forces %.4f and %.4f of the weight; at rest at %.4f (by hand %.3f), by the pressure %.4f\n", law.name, dense.force,
                    loose.force, found, law.expected, carried);
        CHECK(std::abs(found - law.expected) < 0.003); // by hand to 0.001; the filtered lattice is even to as much
        CHECK(std::abs(carried - found) < 0.003);      // the exact balance of weights
        CHECK(std::abs(found - 0.622) < 0.05);         // the measured bed, to what drag laws differ by
    }
    // The seed's law is Ergun's, of packed beds, up to 0.8, where it jumps down: no bed rests below.
    const double packed = lifted(io::DragLaw::seed, 0.79).force, open = lifted(io::DragLaw::seed, 0.82).force;
    std::printf("seed: forces %.3f at 0.79 and %.3f at 0.82 of the weight\n", packed, open);
    CHECK(packed > 0);
    CHECK(open < 0);
}

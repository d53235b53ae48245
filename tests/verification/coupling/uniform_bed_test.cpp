// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Fluid through grains on a lattice that repeats with the cells, so that the volume fraction is uniform to round-off: pressure drop of a
// fixed bed and slip of a free one are those of the drag law itself, through filter, exchange and projection.
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

struct Bed {
    double fraction, diameter, fluid_density, viscosity, grain_density; ///< viscosity dynamic
    io::DragLaw drag = io::DragLaw::ergun;
};

double edge_of(const Bed& bed) { return std::cbrt(std::numbers::pi / 3 / (1 - bed.fraction)) * bed.diameter; } // of body-centred cubes

/// Four cells each way, one cube of the lattice in each.
io::Scene scene_of(const Bed& bed, double gradient, double gravity, double dt)
{
    CoupledBox box;
    box.size = 4 * edge_of(bed) * Vec3::Ones();
    box.cells = {4, 4, 4};
    box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
    box.diameter = bed.diameter;
    box.gravity = {-gravity, 0, 0};
    box.pressure_gradient = gradient;
    box.viscosity = bed.viscosity / bed.fluid_density;
    box.drag = bed.drag;
    box.added_mass = false;
    box.dt = dt;
    box.mode = io::CouplingMode::automatic;
    box.tolerance = 1e-10;
    io::Scene scene = test::scene_of(box, 1);
    scene.fluid->material.density = bed.fluid_density;
    scene.particles.front().density = bed.grain_density;
    return scene;
}

std::vector<Vec3> lattice(double edge)
{
    std::vector<Vec3> places;
    core::for_each({0, 0, 0}, {4, 4, 4}, [&](int i, int j, int k) {
        places.push_back(edge * Vec3(i + 0.2, j + 0.2, k + 0.2));
        places.push_back(edge * Vec3(i + 0.7, j + 0.7, k + 0.7));
    });
    return places;
}

/// Mean of the fluid's velocity along x, and that of the grains [m/s].
std::pair<double, double> velocities(CoupledRun& run)
{
    const double fluid =
        run.integral([&](core::LocalBlock b, int i, int j, int k) { return run.world().fluid()->state().velocity.on(b).x(i, j, k); });
    return {fluid / run.world().mesh().total_volume(), run.mean_grain_velocity().x()};
}

double ergun(const Bed& b, double u)
{
    const double e = b.fraction, d = b.diameter;
    return 150 * (1 - e) * (1 - e) * b.viscosity * u / (e * e * e * d * d) + 1.75 * (1 - e) * b.fluid_density * u * u / (e * e * e * d);
}

} // namespace

TEST_CASE("a fixed bed of uniform fraction has Ergun's pressure drop")
{
    struct Case {
        Bed bed;
        double velocity, drop; ///< superficial [m/s], [Pa/m]
    };
    const Case table[] = {{{0.40, 1e-3, 1000, 1e-3, 1e14}, 0.001, 860.16}, {{0.40, 1e-3, 1000, 1e-3, 1e14}, 0.01, 10078.1},
                          {{0.40, 1e-3, 1000, 1e-3, 1e14}, 0.1, 248437.5}, {{0.36, 2e-3, 1000, 1e-3, 1e14}, 0.05, 46467.8},
                          {{0.45, 1e-3, 1.2, 1.8e-5, 1e14}, 0.2, 2299.6},  {{0.40, 5e-4, 1.2, 1.8e-5, 1e14}, 0.1, 6468.75}};
    for (const Case& c : table) {
        const double drop = ergun(c.bed, c.velocity);
        CHECK(drop == test::relative(c.drop).epsilon(3e-5)); // printed to five or six digits
        // The fluid needs rho U / drop to come up to speed.
        CoupledRun run(scene_of(c.bed, drop, 0, 0.5 * c.bed.fluid_density * c.velocity / drop));
        run.place(lattice(edge_of(c.bed)));
        run.start();
        for (int n = 0; n < 200; ++n) run.step();
        const double found = c.bed.fraction * velocities(run).first;
        std::printf("phi %.2f d %.1f mm U %.3f m/s: found %.8f, off by %.1e\n", c.bed.fraction, 1e3 * c.bed.diameter, c.velocity, found,
                    found / c.velocity - 1);
        CHECK(found == test::relative(c.velocity).epsilon(1e-6)); // the gate
    }
}

TEST_CASE("a free bed of uniform fraction slips at the velocity of minimum fluidisation, and the pressure drop carries its weight")
{
    // NUMERICS C5.2, Ergun's column, in air of 1.2 kg/m3 and 1.8e-5 Pa s (its other one is Wen and Yu's correlation, not their drag law).
    const std::pair<Bed, double> table[] = {{{0.40, 1e-3, 1.2, 1.8e-5, 2500}, .5608}, {{0.42, 1.2e-3, 1.2, 1.8e-5, 1000}, .4044}};
    for (const auto& [bed, expected] : table) {
        const double weight = (bed.grain_density - bed.fluid_density) * (1 - bed.fraction) * 9.81; // [Pa/m]
        CoupledRun run(scene_of(bed, weight, 9.81, 2e-3));
        run.place(lattice(edge_of(bed)));
        run.start();
        for (int n = 0; n < 400; ++n) run.step();
        const auto [fluid, grains] = velocities(run);
        const double found = bed.fraction * (fluid - grains);
        std::printf("phi %.2f, %.0f kg/m3: U %.5f m/s, table %.4f\n", bed.fraction, bed.grain_density, found, expected);
        CHECK(ergun(bed, found) == test::relative(weight).epsilon(1e-4)); // the plateau: the pressure drop carries the bed
        CHECK(found == test::relative(expected).epsilon(2e-4));           // printed to four digits
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A bed between an inflow and an outflow: the pressure drop of its drag law inside, the same flux through every section, closed books of
// momentum, and a free bed whose weight the pressure carries.
// ctest: timeout=120
#include "io/run/momentum_ledger.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <cstdio>
#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace test;

namespace {

constexpr double edge = 4e-3; // of a cell, which holds a cube of two grains [m]
constexpr int along = 20;

/// Up the axis x, from an inflow to an outflow.
io::Scene scene(double velocity, const std::string& grain, const std::string& rest, double dt)
{
    return test::scene_from_text(fmt::format(
        "name: open\ngrid: {{ box: {{ size: [{} mm, 16 mm, 16 mm], cells: [{}, 4, 4], blocks: [2, 1, 1] }}, periodic: [y, z] }}\nfluid:\n"
        "  water: {{ density: 1000 kg/m3, viscosity: 1e-6 m2/s }}\n  boundaries:\n"
        "    - {{ at: x_low, kind: inflow, velocity: [{} m/s, 0 m/s, 0 m/s] }}\n    - {{ at: x_high, kind: outflow }}\n"
        "particles:\n  - {{ name: S, diameter: 3 mm, {} }}\n"
        "contact: {{ stiffness: 5 kN/m, walls: primitive }}\nsolver: {{ tolerance: 1e-10 }}\n{}run: {{ until: 1e3 s, time_step: {} s }}\n",
        along * edge * 1e3, along, velocity, grain, rest, dt));
}

/// Mean of a cell field over a section of the column.
template <class Value>
double section(CoupledRun& run, int i, Value value)
{
    double sum = 0;
    const int half = along / 2;
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 4; ++j) sum += value(core::LocalBlock(i / half), i % half, j, k) / 16;
    return sum;
}

double ergun(double e, double d, double u)
{
    return 150 * (1 - e) * (1 - e) * 1e-3 * u / (e * e * e * d * d) + 1.75 * (1 - e) * 1000 * u * u / (e * e * e * d);
}

double pressure(CoupledRun& run, int i)
{
    return section(run, i, [&](core::LocalBlock b, int x, int j, int k) { return run.world().fluid()->state().pressure.on(b)(x, j, k); });
}

double fraction(CoupledRun& run, int i)
{
    return section(run, i,
                   [&](core::LocalBlock b, int x, int j, int k) { return run.world().coupling()->fields().fraction.on(b)(x, j, k); });
}

} // namespace

TEST_CASE("water that comes in below a fixed bed and goes out above it falls in pressure as Ergun has it, and all of it goes through")
{
    constexpr double velocity = 0.02;
    CoupledRun run(scene(velocity, "count: 480, density: 1e14 kg/m3, initial: { arrangement: lattice }",
                         "coupling: { drag: ergun, added_mass: off }\n", 5e-3));
    std::vector<Vec3> places; // the third to the eighteenth cell, from the first on nothing
    core::for_each({2, 0, 0}, {along - 2, 4, 4}, [&](int i, int j, int k) {
        for (const double at : {0.2, 0.7}) places.push_back(edge * Vec3(i + at, j + at, k + at));
    });
    run.place(places);
    run.start();
    io::MomentumLedger ledger(run.world());
    double defect = 0, exchange = 0;
    for (int n = 0; n < 150; ++n) {
        run.step();
        ledger.update();
        defect = std::max(defect, ledger.defect());
        exchange = std::max(exchange, ledger.exchange_defect());
    }
    const double e = fraction(run, 9), drop = (pressure(run, 8) - pressure(run, 11)) / (3 * edge);
    std::printf("fraction %.6f, pressure gradient %.6f of Ergun's, books %.1e, exchange %.1e\n", e, drop / ergun(e, 3e-3, velocity), defect,
                exchange);
    CHECK(e == test::relative(1 - 2 * std::numbers::pi / 6 * 27 / 64).epsilon(1e-6)); // the ends of the bed reach no further
    // Where the bed begins and ends, within two cells, velocities of cells wave by 1 % from cell to cell: a tenth of that reaches here.
    CHECK(drop == test::relative(ergun(e, 3e-3, velocity)).epsilon(2e-3));
    for (const int i : {0, 1, 5, 10, 19}) {
        const double through = section(run, i, [&](core::LocalBlock b, int x, int j, int k) {
            return std::as_const(run.world().fluid()->state()).flux.on(b).i(x + 1, j, k);
        });
        CHECK(through == test::relative(velocity * edge * edge).epsilon(1e-8)); // the tolerance of the pressure
    }
    CHECK(defect < 1e-9);    // what the solver of the viscosity leaves
    CHECK(exchange < 1e-12); // rounding
}

TEST_CASE("a bed that water lifts is carried by the pressure, which falls by its buoyant weight")
{
    constexpr double velocity = 0.06;
    CoupledRun run(scene(velocity, "count: 300, density: 2500 kg/m3, initial: { low: [2 mm, 0 mm, 0 mm], high: [60 mm, 16 mm, 16 mm] }",
                         "gravity: { direction: -x }\n", 2e-3));
    run.start();
    io::MomentumLedger ledger(run.world());
    double mean = 0, defect = 0;
    const int steps = 1000, from = 500;
    for (int n = 0; n < steps; ++n) {
        run.step();
        ledger.update();
        defect = std::max(defect, ledger.defect());
        // From the floor on, half a cell below the first centre.
        if (n >= from) mean += (1.5 * pressure(run, 0) - 0.5 * pressure(run, 1) - pressure(run, along - 1)) / (steps - from);
    }
    const double weight = 300 * std::numbers::pi / 6 * 27e-9 * 1500 * 9.81 / (16e-3 * 16e-3);
    std::printf("pressure drop over buoyant weight %.4f, books %.1e\n", mean / weight, defect);
    CHECK(mean == test::relative(weight).epsilon(0.02)); // momentum of grains at both ends of a second over their weight in it
    CHECK(defect < 1e-9);
    CHECK(run.grains().owned == 300);
}

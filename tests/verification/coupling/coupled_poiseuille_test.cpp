// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Added mass resists what accelerates relative to the fluid: where the fluid flows steadily and straight it does nothing, although the
// pressure falls.
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

constexpr double gradient = 10, viscosity = 1e-4, height = 8e-3;

/// One grain of a thousandth of a cell in the flow between two plates, a hundred times too heavy to be moved, in water that is 100
/// times as viscous.
CoupledBox channel()
{
    CoupledBox box;
    box.size = {8e-3, height, 8e-3};
    box.cells = {4, 16, 4};
    box.periodic = {io::Axis::x, io::Axis::z};
    box.diameter = 1e-4;
    box.density_ratio = 100;
    box.viscosity = viscosity;
    box.pressure_gradient = gradient;
    box.filter = 10;
    return box;
}

double told(CoupledRun& run) { return run.grains().columns[std::size_t(run.world().coupling()->exchange().columns().told)][0]; }

} // namespace

TEST_CASE("a grain in steady flow between plates feels the pressure's gradient and no added mass")
{
    for (const io::CouplingMode mode : every_mode) {
        CoupledBox box = channel();
        box.mode = mode;
        CoupledRun run(box, 1);
        run.place({Vec3(3.1e-3, 4e-3, 4.2e-3)});
        run.start();
        const double drive = gradient / 1000; // [m/s2]
        run.step();
        run.step();
        // Nothing is felt yet of the walls 4 mm away, sqrt(4 nu t) is 0.9 mm; but the grain, at rest, holds back what the filter shows it.
        const double start = told(run) / drive;
        while (run.world().time() < 0.6) run.step(); // nine times h^2 / (pi^2 nu)
        const auto& columns = run.world().coupling()->exchange().columns();
        const auto along = [&](int column) { return run.grains().columns[std::size_t(column)][0]; };
        const double volume = run.solid_volume();
        const double owed = along(columns.delivered) / run.world().clock().dt, stress = volume * along(columns.force_used);
        const double pressure = along(columns.known_force) - owed - stress;
        std::printf("%-10s told of the drive: at the start %.5f, in steady flow %.1e; force of pressure %.6f, of stress %.4f of V G\n",
                    run.world().mode_reason().substr(0, 9).c_str(), start, told(run) / drive, pressure / (volume * gradient),
                    stress / (volume * gradient));
        CHECK(start == test::relative(1.0).epsilon(2e-3));
        // exp(-9) = 1e-4 is left of the start.
        CHECK(std::abs(told(run)) < 5e-4 * drive);
        CHECK(pressure == test::relative(volume * gradient).epsilon(1e-9)); // round-off
        CHECK(stress == test::relative(-volume * gradient).epsilon(1e-3));  // which balances it
    }
}

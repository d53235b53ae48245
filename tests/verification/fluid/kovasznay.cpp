// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Kovasznay's exact flow behind a grid at Re = 40 (NUMERICS C1.3), its velocity given where it enters and leaves: on a box, on a wavy
// one, and on blocks whose points do not match in the middle.
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using std::numbers::pi;

constexpr double reynolds = 40;
const double lambda = reynolds / 2 - std::sqrt(reynolds * reynolds / 4 + 4 * pi * pi);

Vec3 velocity(const Vec3& x)
{
    const double e = std::exp(lambda * x.x());
    return {1 - e * std::cos(2 * pi * x.y()), lambda / (2 * pi) * e * std::sin(2 * pi * x.y()), 0};
}
double pressure(const Vec3& x) { return 500 * (1 - std::exp(2 * lambda * x.x())); } // density 1000

core::MultiBlock box(double low, double high, int cells_along, int cells_up)
{
    return core::make_box({{low, -0.5, 0}, {high, 0.5, 0.25}, {cells_along, cells_up, 1}, {1, 1, 1}, {false, true, true}});
}

/// From x = -0.5 to 1, the waves periodic along y and level at both ends.
core::MultiBlock wavy(int cells)
{
    return core::make_box({{-0.5, -0.5, 0}, {1, 0.5, 0.25}, {3 * cells / 2, cells, 1}, {1, 1, 1}, {false, true, true}}, [](const Vec3& x) {
        const double bend = 0.03 * std::sin(2 * pi / 1.5 * (x.x() + 0.5));
        return Vec3(x + Vec3(bend * std::cos(2 * pi * x.y()), bend * std::sin(2 * pi * x.y()), 0));
    });
}

/// `ratio` times as many cells up to x = 0.25 as behind.
core::MultiBlock joined(int cells, int ratio)
{
    const core::Box front{{-0.5, -0.5, 0}, {0.25, 0.5, 0.25}, {3 * cells / 4, cells, 1}, {1, 1, 1}, {}};
    const core::Box behind{{0.25, -0.5, 0}, {1, 0.5, 0.25}, {3 * cells / 4, cells / ratio, 1}, {1, 1, 1}, {}};
    core::MultiBlock grid = test::joined({front, behind}, {{0, 1, 0}, {0, 0, 0.25}}, [](const Vec3& x) { return x; });
    grid.boundary_name = [](core::BlockId, core::Side side) { return side == core::Side::i_low ? "x_low" : "x_high"; };
    return grid;
}

struct Errors {
    double velocity, pressure, divergence;
};

Errors errors(core::MultiBlock grid, int cells)
{
    physics::FluidParameters p;
    p.viscosity = 1 / reynolds;
    p.tolerances = {.pressure = 1e-11, .viscosity = 1e-11};
    for (const char* end : {"x_low", "x_high"}) p.boundaries[end] = {.kind = physics::BoundaryKind::inflow, .profile = velocity};
    test::FluidRun run(std::move(grid), p);
    run.start(velocity, pressure);
    // From the exact flow to that of the scheme: four times the length over the mean speed. The fastest fluid, 2.6, crosses 0.8 cells.
    for (int n = 0; n < 20 * cells; ++n) run.step(0.3 / cells);
    const Errors e{run.velocity_error(velocity), run.pressure_error(pressure) / 1000, run.divergence()};
    MESSAGE(cells, " cells up: velocity ", e.velocity, ", pressure ", e.pressure, ", divergence ", e.divergence);
    return e;
}

} // namespace

TEST_CASE("Kovasznay's flow on a box, to second order")
{
    const Errors coarse = errors(box(-0.5, 1, 24, 16), 16), fine = errors(box(-0.5, 1, 48, 32), 32);
    CHECK(std::log2(coarse.velocity / fine.velocity) > 1.8);
    CHECK(std::log2(coarse.pressure / fine.pressure) > 1.5);
}

TEST_CASE("Kovasznay's flow on a wavy grid, to second order")
{
    const Errors coarse = errors(wavy(16), 16), fine = errors(wavy(32), 32);
    CHECK(std::log2(coarse.velocity / fine.velocity) > 1.8);
    CHECK(std::log2(coarse.pressure / fine.pressure) > 1.5);
}

TEST_CASE("Kovasznay's flow through blocks with 2, 3 and 8 times fewer points on one side, to second order")
{
    for (const int ratio : {2, 3, 8}) {
        const Errors coarse = errors(joined(24, ratio), 24), fine = errors(joined(48, ratio), 48);
        CHECK(fine.divergence < 1e-12); // NUMERICS C1.3: an interface loses nothing
        CHECK(std::log2(coarse.velocity / fine.velocity) > 1.8);
        CHECK(std::log2(coarse.pressure / fine.pressure) > 1.5);
    }
}

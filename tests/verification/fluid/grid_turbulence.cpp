// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Turbulence that enters with a uniform stream and decays on its way, as behind a grid of bars.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::BoundaryKind;

constexpr double speed = 1.0, length = 1.0;
constexpr physics::Turbulence entering{1e-4, 5e-4}; // so weak that it does not diffuse: nu_t / (speed length) is 2e-6

/// Largest error of k over its value, once what was there at the start has left.
double decay_error(int cells)
{
    physics::FluidParameters p;
    p.viscosity = 1e-7;
    p.boundaries["x_low"] = {.kind = BoundaryKind::inflow, .velocity = {speed, 0, 0}};
    p.boundaries["x_high"] = {.kind = BoundaryKind::outflow};
    for (const char* wall : {"y_low", "y_high"}) p.boundaries[wall] = {.kind = BoundaryKind::slip};
    const core::Box box{{0, 0, 0}, {length, 0.2, 0.1}, {cells, 2, 1}, {2, 1, 1}, {false, false, true}};
    const test::Carried carried{.turbulence = physics::TurbulenceParameters{{1e-6, 1e-6}, {{"x_low", entering}}, 0.0}};
    test::FluidRun run(core::make_box(box), p, {.kind = "serial"}, core::Communicator::world(), carried);
    run.start([](const Vec3&) { return Vec3(speed, 0, 0); });
    for (int n = 0; n < 4 * cells; ++n) run.step(0.5 * length / cells / speed);
    return run.largest([&](core::LocalBlock b, int i, int j, int k) {
        const double turnovers = run.centre(b, i, j, k).x() / speed * entering.epsilon / entering.k;
        return run.turbulence().k().on(b)(i, j, k) / (entering.k * std::pow(1 + 0.92 * turnovers, -1 / 0.92)) - 1;
    });
}

} // namespace

TEST_CASE("turbulence decays behind a grid as its power law says, to first order at least")
{
    const double coarse = decay_error(40), fine = decay_error(80);
    MESSAGE("largest error of k, 40 and 80 cells: ", coarse, ", ", fine);
    CHECK(fine < 0.05);
    CHECK(std::log2(coarse / fine) > 0.9);
}

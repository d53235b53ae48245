// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Blocks whose points do not match: a uniform flow stays uniform (NUMERICS C0 U3), no volume is lost between them.
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

const Vec3 uniform(0.7, -0.4, 0.5);

double displacement_rate(test::FluidRun& run)
{
    double largest = 0;
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b)
        largest = std::max(largest, physics::transport_rates(run.mesh().geometry(b), run.fluid().state().velocity.on(b)).displacement);
    return largest;
}

/// Largest change of velocity after 20 steps in which the flow crosses half a cell each.
double change(core::MultiBlock grid, double viscosity)
{
    physics::FluidParameters water;
    water.viscosity = viscosity;
    test::FluidRun run(std::move(grid), water);
    run.start([&](const Vec3&) { return uniform; });
    const double dt = 0.5 / displacement_rate(run);
    for (int n = 0; n < 20; ++n) run.step(dt);
    CHECK(run.divergence() < 1e-13);
    return run.largest([&](core::LocalBlock b, int i, int j, int k) { return (run.velocity(b, i, j, k) - uniform).norm(); });
}

Vec3 vortices(const Vec3& x)
{
    return {std::sin(x.x()) * std::cos(x.y()), -std::cos(x.x()) * std::sin(x.y()), 0.2 * std::sin(x.x() + x.y())};
}

} // namespace

TEST_CASE("a uniform flow stays uniform on wavy, turned blocks whose points do not match")
{
    for (const double viscosity : {1e-3, 0.0}) {
        CHECK(change(test::wavy_halves({{6, 8, 6}, {6, 12, 9}}, 0.3, 37), viscosity) < 1e-12);
        CHECK(change(test::wavy_halves({{6, 5, 6}, {4, 10, 24}}, 0.3, 37), viscosity) < 1e-12);
        CHECK(change(test::wavy_halves({{6, 5, 4}, {4, 40, 32}}, 0.2, 37), viscosity) < 1e-12);
    }
}

TEST_CASE("what one block loses through an interface the other gains")
{
    physics::FluidParameters water;
    water.viscosity = 1e-2;
    test::FluidRun run(test::wavy_halves({{6, 8, 6}, {4, 12, 9}}, 0.3, 37), water);
    run.start(vortices);
    const double dt = 0.5 / displacement_rate(run);
    for (int n = 0; n < 10; ++n) run.step(dt);
    std::array<double, 2> out{};
    double through = 0;
    for (core::LocalBlock b = 0; b < 2; ++b) {
        const auto flux = run.fluid().state().flux.on(b).i;
        const core::Extents n = run.mesh().geometry(b).cells;
        for (int k = 0; k < n.nk; ++k)
            for (int j = 0; j < n.nj; ++j) {
                out[std::size_t(b)] += flux(n.ni, j, k) - flux(0, j, k);
                through += std::abs(flux(n.ni, j, k));
            }
    }
    const int iterations = run.fluid().pressure_system().report().iterations;
    MESSAGE("mass defect over both interfaces " << std::abs(out[0] + out[1]) / through << ", " << iterations
                                                << " iterations for the pressure");
    CHECK(std::abs(out[0] + out[1]) < 1e-12 * through);
    CHECK(iterations <= 20);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Flow between cylinders that turn, in one sector: exact (Couette 1890), u = a r + b / r around the axis.
#include "tests/support/turned_grids.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::AdvectionScheme;

/// Of an inner cylinder at 1 rad/s and an outer one at `outer`, radii 0.5 and 1.
Vec3 couette(const Vec3& x, double outer)
{
    const double r = test::radius(x), a = (outer - 0.25) / 0.75, b = 0.25 * (1 - outer) / 0.75;
    return test::cylindrical(x, 0, 0, a * r + b / r);
}

/// Relative error of the velocity after `time`, started from the exact flow.
double error(int n, double outer, AdvectionScheme scheme, double time)
{
    auto liquid = test::between_cylinders(0.05, scheme);
    liquid.boundaries["outer"].profile = [outer](const Vec3& x) -> Vec3 { return outer * Vec3::UnitX().cross(x); };
    test::FluidRun run(test::ring_sector({1, n, n}), liquid);
    const auto exact = [outer](const Vec3& x) { return couette(x, outer); };
    run.start(exact);
    const double dt = 0.4 / n;
    while (run.time() < time - 0.5 * dt) run.step(dt);
    const Vec3 mean = run.budget().after;
    CHECK(std::abs(mean.x()) < 1e-12); // along the axis nothing drives it
    return run.velocity_error(exact);
}

} // namespace

TEST_CASE("flow between cylinders in one sector is steady and second order")
{
    for (const auto scheme : {AdvectionScheme::lcsi, AdvectionScheme::finite_volume}) {
        const double coarse = error(8, -0.2, scheme, 2), fine = error(16, -0.2, scheme, 2);
        MESSAGE("scheme ", int(scheme), ": ", coarse, ", ", fine, ", order ", std::log2(coarse / fine));
        CHECK(std::log2(coarse / fine) > 1.8);
        CHECK(fine < 1e-3); // of a wall at 0.5 m/s
    }
}

TEST_CASE("a liquid that turns with its walls as a solid keeps doing so")
{
    for (const auto scheme : {AdvectionScheme::lcsi, AdvectionScheme::finite_volume}) {
        const double coarse = error(8, 1, scheme, 2), fine = error(16, 1, scheme, 2);
        MESSAGE("scheme ", int(scheme), ": ", coarse, ", ", fine);
        CHECK(std::log2(coarse / fine) > 1.8);
        CHECK(fine < 1e-4);
    }
}

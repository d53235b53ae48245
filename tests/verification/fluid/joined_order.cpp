// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300 long
// A decaying Beltrami flow through two interfaces whose points are in the ratios 1:1, 2:3, 1:2, 1:4 and 1:8 (NUMERICS B8, C1.1).
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

constexpr double viscosity = 0.05;

/// Its vorticity is the velocity itself, so that it decays as exp(-viscosity t) without changing its shape.
Vec3 beltrami(const Vec3& x, double time)
{
    const Vec3 u(std::sin(x.z()) + 0.7 * std::cos(x.y()), 0.5 * std::sin(x.x()) + std::cos(x.z()),
                 0.7 * std::sin(x.y()) + 0.5 * std::cos(x.x()));
    return std::exp(-viscosity * time) * u;
}
/// Of unit density.
double pressure(const Vec3& x, double time) { return -0.5 * beltrami(x, time).squaredNorm(); }

struct Errors {
    double velocity, pressure;
    int iterations; ///< of the last step
};

/// Cells of the second half for each of the first along the interface: along / per.
struct Ratio {
    int along, per;
};

Errors errors(int n, Ratio ratio, physics::AdvectionScheme scheme)
{
    physics::FluidParameters water;
    water.density = 1;
    water.viscosity = viscosity;
    water.advection = scheme;
    const int fine = n * ratio.along / ratio.per;
    test::FluidRun run(test::wavy_halves({{n / 2, n, n}, {n / 2, fine, fine}}, 0.2, 0), water);
    run.start([](const Vec3& x) { return beltrami(x, 0); }, [](const Vec3& x) { return pressure(x, 0); });
    run.fluid().state().clock.steps_since_jump = 2;
    const int steps = fine;
    const double dt = 1.0 / steps;
    for (int s = 0; s < steps; ++s) run.step(dt);
    const Errors e{run.velocity_error([&](const Vec3& x) { return beltrami(x, run.time()); }),
                   run.pressure_error([&](const Vec3& x) { return pressure(x, run.time() - dt / 2); }),
                   run.fluid().pressure_system().report().iterations};
    MESSAGE(ratio.per << ":" << ratio.along << ", " << n << " cells: velocity " << e.velocity << ", pressure " << e.pressure
                      << ", iterations " << e.iterations);
    return e;
}

/// @param n  Cells along each edge of the first half of the coarser grid.
void check_order(Ratio ratio, physics::AdvectionScheme scheme, int n = 10)
{
    const Errors coarse = errors(n, ratio, scheme), fine = errors(2 * n, ratio, scheme);
    const double velocity = std::log2(coarse.velocity / fine.velocity), p = std::log2(coarse.pressure / fine.pressure);
    MESSAGE(ratio.per << ":" << ratio.along << ": observed orders " << velocity << " (velocity), " << p << " (pressure)");
    CHECK(velocity > 1.9);
    CHECK(p > 1.7); // the mean pressure of a step is compared with the one in its middle
    CHECK(fine.iterations <= 20);
}

} // namespace

TEST_CASE("a flow through blocks whose points do not match is second order at any ratio")
{
    for (const Ratio ratio : {Ratio{1, 1}, {3, 2}, {2, 1}, {4, 1}}) check_order(ratio, physics::AdvectionScheme::lcsi);
    check_order({8, 1}, physics::AdvectionScheme::lcsi, 8);
}

TEST_CASE("so it is in finite volumes")
{
    for (const Ratio ratio : {Ratio{3, 2}, {2, 1}}) check_order(ratio, physics::AdvectionScheme::finite_volume);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Turbulence that is missing, does not dissipate, or is strained faster than it can follow (NUMERICS D 35, D 36).
#include "tests/support/fluid_run.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::BoundaryKind;

struct Duct {
    physics::Turbulence start;
    physics::WallTreatment walls = physics::WallTreatment::functions;
};

/// Water of 1e-4 m2/s between plates 0.1 m apart, driven so that its laminar flow would be 1 m/s in the middle; none: without a model.
std::unique_ptr<test::FluidRun> flow_between_plates(const std::optional<Duct>& duct, double dt, int steps)
{
    physics::FluidParameters fluid;
    fluid.viscosity = 1e-4;
    fluid.drive = physics::ConstantDrive{Vec3(8e-2, 0, 0)};
    const core::Box box{{0, 0, 0}, {100, 0.1, 0.1}, {2, 16, 1}, {1, 2, 1}, {true, false, true}};
    test::Carried carried;
    if (duct) carried.turbulence = physics::TurbulenceParameters{duct->start, {}, 0, duct->walls};
    auto run = std::make_unique<test::FluidRun>(core::make_box(box), fluid, tasks::ExecutorOptions{.kind = "serial"},
                                                core::Communicator::self(), carried);
    run->start([](const Vec3&) { return Vec3(0, 0, 0); });
    for (int n = 0; n < steps; ++n) run->step(dt);
    return run;
}

double largest_eddy_viscosity(test::FluidRun& run)
{
    double most = 0;
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b) {
        const auto eddy = run.turbulence().eddy_viscosity(b);
        core::for_each_cell(eddy.extents(), [&](int i, int j, int k) { most = std::max(most, eddy(i, j, k)); });
    }
    return most;
}

} // namespace

TEST_CASE("without turbulence at the start a flow is the laminar one with straight lines at its walls")
{
    const auto laminar = flow_between_plates(std::nullopt, 0.25, 200);
    const auto functions = physics::WallTreatment::functions, resolved = physics::WallTreatment::resolved;
    // Resolved to the wall, the little that there is dies at this Reynolds number of 667; with functions any turbulence would grow.
    for (const Duct& duct : {Duct{{0, 0}, functions}, Duct{{0, 1}, functions}, Duct{{0, 0}, resolved}, Duct{{1e-14, 1e-12}, resolved}}) {
        const auto run = flow_between_plates(duct, 0.25, 200);
        const double most = run->largest(
            [&](core::LocalBlock b, int i, int j, int k) { return run->velocity(b, i, j, k).x() - laminar->velocity(b, i, j, k).x(); });
        // Models of turbulence take straight lines in the cells at walls: G h^2 / (8 nu) more than with parabolas once the flow is steady,
        // here to exp(-50 s x pi^2 nu / H^2) = 0.7 %.
        constexpr double cell = 0.1 / 16, straight = 8e-2 * cell * cell / (8 * 1e-4);
        CHECK(most == test::relative(straight).epsilon(0.01));
        CHECK(largest_eddy_viscosity(*run) < 1e-8 * 1e-4);
    }
}

TEST_CASE("turbulence that does not dissipate mixes no more than the bound allows, and ends")
{
    for (const auto walls : {physics::WallTreatment::functions, physics::WallTreatment::resolved})
        for (const double dt : {1e-3, 1.0}) {
            const auto run = flow_between_plates(Duct{{0.01, 0}, walls}, dt, 100);
            CHECK(largest_eddy_viscosity(*run) <= 1e5 * 1e-4 * (1 + 1e-12));
            const double fastest = run->largest([&](core::LocalBlock b, int i, int j, int k) { return run->velocity(b, i, j, k).x(); });
            CHECK(fastest <= 8e-2 * 100 * dt * (1 + 1e-9)); // the drive without friction
            const double sick = run->largest([&](core::LocalBlock b, int i, int j, int m) {
                const double k = run->turbulence().k().on(b)(i, j, m), epsilon = run->turbulence().epsilon().on(b)(i, j, m);
                return k > 0 && epsilon > 0 && std::isfinite(k) && std::isfinite(epsilon) ? 0.0 : 1.0;
            });
            CHECK(sick == 0);
        }
}

TEST_CASE("at a stagnation point no normal stress becomes negative, though turbulence is a hundred times slower than the strain")
{
    constexpr double speed = 1.0;
    physics::FluidParameters fluid;
    fluid.viscosity = 1e-5;
    fluid.boundaries["y_high"] = {.kind = BoundaryKind::inflow, .velocity = {0, -speed, 0}};
    fluid.boundaries["y_low"] = {.kind = BoundaryKind::slip};
    for (const char* side : {"x_low", "x_high"}) fluid.boundaries[side] = {.kind = BoundaryKind::outflow};
    // The strain of the flow (x, -y) is S = 2 / s.
    const physics::Turbulence entering{0.01, 2e-4};
    const core::Box box{{-1, 0, 0}, {1, 1, 0.1}, {32, 16, 1}, {2, 1, 1}, {false, false, true}};
    const test::Carried carried{.turbulence = physics::TurbulenceParameters{entering, {{"y_high", entering}}, 0}};
    test::FluidRun run(core::make_box(box), fluid, {.kind = "serial"}, core::Communicator::self(), carried);
    run.start([](const Vec3& x) { return Vec3(x.x(), -x.y(), 0); });
    for (int n = 0; n < 400; ++n) run.step(0.02);
    double least_stress = 1, most = 0, fastest = 0;
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b) {
        const auto eddy = run.turbulence().eddy_viscosity(b);
        core::for_each({2, 1, 0}, {14, 15, 1}, [&](int i, int j, int m) {
            const double dx = 1.0 / 16, along = (run.velocity(b, i + 1, j, m).x() - run.velocity(b, i - 1, j, m).x()) / (2 * dx);
            const double k = run.turbulence().k().on(b)(i, j, m), unbounded = 0.09 * k * k / run.turbulence().epsilon().on(b)(i, j, m);
            least_stress = std::min(least_stress, 1 - 3 * eddy(i, j, m) * std::abs(along) / k);
            most = std::max(most, unbounded / eddy(i, j, m));
            fastest = std::max(fastest, k);
        });
    }
    MESSAGE("least normal stress over 2 k / 3: ", least_stress, ", eddy viscosity up to ", most,
            " times too large without bound, largest k ", fastest);
    CHECK(least_stress > -0.01); // the bound follows the flow one step behind
    CHECK(most > 2);
    CHECK(fastest < 0.5 * speed * speed);
}

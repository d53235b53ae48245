// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Boundaries through which fluid flows, and those along which it slips, in a channel turned by 37 degrees.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::BoundaryKind;

constexpr double height = 0.02, length = 0.06, mean_speed = 0.03, density = 1000, viscosity = 1e-4;

/// From the frame of the channel (flow along x, walls across y) to that of the scene.
Vec3 turned(const Vec3& x)
{
    static const double angle = 37 * std::numbers::pi / 180;
    return {std::cos(angle) * x.x() - std::sin(angle) * x.y(), std::sin(angle) * x.x() + std::cos(angle) * x.y(), x.z()};
}
Vec3 turned_back(const Vec3& x) { return {turned({x.x(), -x.y(), 0}).x(), -turned({x.x(), -x.y(), 0}).y(), x.z()}; }

/// @param cells  Across the channel.
/// @param top    Of the channel; the middle is at height / 2.
core::MultiBlock channel(int cells, double top = height)
{
    const core::Box box{{0, 0, 0}, {length, top, height}, {cells, cells, 2}, {2, 2, 1}, {false, false, true}};
    return core::make_box(box, [](const Vec3& x) { return turned(x); });
}

double parabola(double y) { return 6 * mean_speed * y / height * (1 - y / height); }
Vec3 poiseuille(const Vec3& x) { return turned({parabola(turned_back(x).y()), 0, 0}); }

physics::FluidParameters water(double nu = viscosity)
{
    physics::FluidParameters p;
    p.density = density;
    p.viscosity = nu;
    p.tolerances = {.pressure = 1e-11, .viscosity = 1e-11};
    return p;
}

double largest_difference(const test::FluidRun& run, const test::VectorFunction& expected)
{
    return run.largest(
        [&](core::LocalBlock b, int i, int j, int k) { return (run.velocity(b, i, j, k) - expected(run.centre(b, i, j, k))).norm(); });
}

/// Error of Poiseuille's flow, over the mean speed, after it was made from rest by a parabolic inflow.
double developed_error(int cells, BoundaryKind exit)
{
    auto p = water();
    p.boundaries["x_low"] = {.kind = BoundaryKind::inflow, .profile = poiseuille};
    p.boundaries["x_high"] = {.kind = exit};
    test::FluidRun run(channel(cells), p);
    run.start([](const Vec3&) { return Vec3(0, 0, 0); });
    // Viscosity needs height^2 / (pi^2 viscosity) = 0.4 s, the stream 2 s through the channel.
    for (int n = 0; n < 100 * cells / 8; ++n) run.step(0.08 * 8 / cells);
    CHECK(run.divergence() < 1e-9);
    return run.velocity_error(poiseuille) / mean_speed;
}

} // namespace

TEST_CASE("a parabolic inflow makes Poiseuille's flow, to round-off")
{
    for (const BoundaryKind exit : {BoundaryKind::outflow, BoundaryKind::pressure}) {
        const double coarse = developed_error(8, exit), fine = developed_error(16, exit);
        MESSAGE("error over mean speed, 8 and 16 cells: ", coarse, ", ", fine);
        CHECK(std::max(coarse, fine) < 1e-9); // what solvers leave: cells and walls have parabolas exactly
    }
}

TEST_CASE("a difference of pressure between open ends drives what the same gradient drives through periodic ends")
{
    const double gradient = 12 * density * viscosity * mean_speed / (height * height);
    auto open = water();
    open.boundaries["x_low"] = {.kind = BoundaryKind::pressure, .pressure = gradient * length};
    open.boundaries["x_high"] = {.kind = BoundaryKind::pressure};
    test::FluidRun run(channel(16), open);
    auto closed = water();
    closed.drive = physics::ConstantDrive{turned({gradient / density, 0, 0})};
    core::MultiBlock grid = channel(16);
    grid.periods.push_back(turned({length, 0, 0}));
    test::FluidRun periodic(std::move(grid), closed);
    periodic.start([](const Vec3&) { return Vec3(0, 0, 0); });
    run.start([](const Vec3&) { return Vec3(0, 0, 0); }, [&](const Vec3& x) { return gradient * (length - turned_back(x).x()); });
    for (int n = 0; n < 40; ++n) {
        run.step(0.01);
        periodic.step(0.01);
    }
    const double difference = run.largest(
        [&](core::LocalBlock b, int i, int j, int k) { return (run.velocity(b, i, j, k) - periodic.velocity(b, i, j, k)).norm(); });
    CHECK(difference < 1e-8 * mean_speed); // the tolerance of both solvers is 1e-11, and errors add up
}

TEST_CASE("a uniform flow through open ends stays uniform between slip walls, and with them moving across")
{
    for (const double nu : {0.0, 1e-3})
        for (const bool across : {false, true}) {
            const Vec3 flow = turned({0.3, across ? 0.1 : 0.0, 0});
            auto p = water(nu);
            p.boundaries["x_low"] = {.kind = BoundaryKind::inflow, .velocity = flow};
            p.boundaries["x_high"] = {.kind = BoundaryKind::outflow};
            for (const auto* wall : {"y_low", "y_high"}) p.boundaries[wall] = {.kind = BoundaryKind::slip, .velocity = flow};
            test::FluidRun run(channel(8), p);
            run.start([&](const Vec3&) { return flow; });
            for (int n = 0; n < 20; ++n) run.step(0.005);
            CHECK(largest_difference(run, [&](const Vec3&) { return flow; }) < 1e-12); // round-off of 20 steps
        }
}

TEST_CASE("half a channel with a plane of symmetry flows as the lower half of the whole")
{
    // Along the axes: advected values are clipped component by component, which is not the same in a turned frame.
    const auto upright = [](double top, int blocks) {
        const core::Box box{{0, 0, 0}, {length, top, height}, {16, 8 * blocks, 2}, {2, blocks, 1}, {true, false, true}};
        return core::make_box(box);
    };
    auto p = water();
    p.drive = physics::harmonic_drive({5.0, 0, 0}, 2 * std::numbers::pi / 0.2);
    test::FluidRun whole(upright(height, 2), p);
    p.boundaries["y_high"] = {.kind = BoundaryKind::symmetry};
    test::FluidRun half(upright(height / 2, 1), p);
    const auto vortices = [](const Vec3& at) {
        const Vec3 x = 2 * std::numbers::pi * at.cwiseQuotient(Vec3(length, height, 1));
        return Vec3(0.1 * std::sin(x.x()) * std::cos(x.y()), -0.1 * height / length * std::cos(x.x()) * std::sin(x.y()), 0);
    };
    for (test::FluidRun* r : {&whole, &half}) r->start(vortices);
    for (int n = 0; n < 20; ++n) {
        whole.step(0.005);
        half.step(0.005);
    }
    // The lower blocks of the whole come first.
    const double difference = half.largest(
        [&](core::LocalBlock b, int i, int j, int k) { return (half.velocity(b, i, j, k) - whole.velocity(b, i, j, k)).norm(); });
    const double fastest = half.largest([&](core::LocalBlock b, int i, int j, int k) { return half.velocity(b, i, j, k).norm(); });
    CHECK(difference < 1e-9 * fastest); // the tolerance of both solvers is 1e-11, and errors add up
}

TEST_CASE("the momentum that flows through boundaries is in the books")
{
    auto p = water();
    p.boundaries["x_low"] = {.kind = BoundaryKind::inflow, .profile = poiseuille};
    p.boundaries["x_high"] = {.kind = BoundaryKind::outflow};
    test::FluidRun run(channel(8), p);
    run.start([](const Vec3&) { return Vec3(0, 0, 0); });
    for (int n = 0; n < 30; ++n) {
        run.step(0.05);
        const auto budget = run.budget();
        const double largest = std::max({budget.after.norm(), budget.through.norm(), budget.pressure.norm(), budget.viscosity.norm()});
        CHECK(budget.defect().norm() < 1e-8 * largest); // what the solver of the viscosity leaves
    }
}

TEST_CASE("a flow that turns back through an outflow does not feed on itself")
{
    auto p = water(1e-6);
    p.drive = physics::harmonic_drive(turned({8.0, 0, 0}), 2 * std::numbers::pi / 0.2);
    p.boundaries["x_low"] = {.kind = BoundaryKind::outflow};
    p.boundaries["x_high"] = {.kind = BoundaryKind::outflow};
    test::FluidRun run(channel(16), p);
    run.start([](const Vec3& x) {
        return turned({0.05 * std::sin(300 * turned_back(x).y()), 0.02 * std::sin(200 * turned_back(x).x()), 0});
    });
    // The drive alone gives at most A T / (2 pi) = 0.25 m/s about any start.
    double fastest = 0;
    for (int n = 0; n < 800; ++n) {
        run.step(0.002);
        fastest = std::max(fastest, run.largest([&](core::LocalBlock b, int i, int j, int k) { return run.velocity(b, i, j, k).norm(); }));
    }
    MESSAGE("fastest in eight periods: ", fastest, " m/s");
    CHECK(fastest < 2 * 8.0 * 0.2 / (2 * std::numbers::pi));
}

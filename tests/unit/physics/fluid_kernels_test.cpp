// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/comm/halo.hpp"
#include "core/grid/box.hpp"
#include "physics/coupling/time_step.hpp"
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/drive.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/hermite.hpp"
#include "tests/support/relative.hpp"
#include <complex>
#include <doctest/doctest.h>
#include <numbers>

using core::Vec3;

TEST_CASE("Hermite weights interpolate cubics exactly on either side")
{
    const auto cubic = [](double x) { return 1 + x * (2 - x * (0.5 + 0.3 * x)); };
    for (const double s : {-1.0, -0.7, -0.25, 0.0, 0.3, 0.99, 1.0}) {
        double w[7], sum = 0;
        physics::hermite_weights(s, w, 1);
        for (int p = 0; p < 7; ++p) sum += w[p] * cubic(p - 3);
        CHECK(sum == test::relative(cubic(s)).epsilon(1e-14));
    }
}

TEST_CASE("Hermite interpolation amplifies no mode")
{
    double largest = 0;
    for (double s = -1; s <= 1; s += 0.01)
        for (double angle = 0; angle <= std::numbers::pi; angle += 0.01) {
            double w[7];
            physics::hermite_weights(s, w, 1);
            std::complex<double> gain = 0;
            for (int p = 0; p < 7; ++p) gain += w[p] * std::polar(1.0, angle * (p - 3));
            largest = std::max(largest, std::abs(gain));
        }
    CHECK(largest < 1 + 1e-14);
}

TEST_CASE("least-squares gradients of a linear field are exact on a wavy grid, walls included")
{
    const auto wavy = [](const Vec3& x) { return Vec3(x + 0.04 * Vec3(std::sin(6 * x.y()), std::sin(5 * x.z()), std::sin(6 * x.x()))); };
    const core::Mesh mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {6, 5, 4}, {1, 1, 1}}, wavy), 0, 1);
    const auto& geometry = mesh.geometry(0);
    core::ScalarField q({"q", "", 1, false}, mesh.own_cells());
    core::VectorField g({"g", "", 1, false}, mesh.own_cells());
    q.allocate();
    g.allocate();
    const Vec3 slope(1, -2, 3);
    // Mirrored centres make the halo of a linear field linear: both kinds of matrices must see the same slope inside.
    core::for_each({-1, -1, -1}, {7, 6, 5}, [&](int i, int j, int k) { q.on(0)(i, j, k) = slope.dot(geometry.centre(i, j, k)); });
    physics::gradient(geometry, geometry.wall_gradient, q.on(0), g.on(0));
    const auto error = [&](int i, int j, int k) {
        return (Vec3(g.on(0).x(i, j, k), g.on(0).y(i, j, k), g.on(0).z(i, j, k)) - slope).norm();
    };
    double worst = 0;
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) { worst = std::max(worst, error(i, j, k)); });
    CHECK(worst < 1e-12);
}

TEST_CASE("mirrored velocity has the wall's value in the middle, also in a block thinner than its halo")
{
    const core::Mesh mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {4, 1, 2}, {1, 1, 1}, {true, false, true}}), 0, 1);
    const auto walls = physics::make_walls(mesh, {{"y_high", {.velocity = Vec3(2, 0, 0)}}});
    core::VectorField u({"u", "", 3, false}, mesh.own_cells());
    u.allocate();
    u.on(0).x(1, 0, 1) = 0.5;
    physics::mirror_velocity(walls[0], 3, u.on(0));
    // Walls at rest below and at 2 above: the value alternates and rises by 4 every two layers.
    CHECK(u.on(0).x(1, -1, 1) == -0.5);
    CHECK(u.on(0).x(1, 1, 1) == 3.5);
    CHECK(u.on(0).x(1, 2, 1) == 4.5);
    CHECK(u.on(0).x(1, -2, 1) == -3.5);
    CHECK_THROWS_AS((void)physics::make_walls(mesh, {{"lid", {}}}), core::ConfigError);
}

TEST_CASE("the impulse of a harmonic drive is the integral of its acceleration")
{
    const physics::Drive drive = physics::harmonic_drive(Vec3(3, 0, 0), 2.0, 0.4);
    const double t = 0.7, dt = 0.9;
    const double exact = 3 / 2.0 * (std::sin(2 * (t + dt) + 0.4) - std::sin(2 * t + 0.4));
    CHECK(dt * physics::mean_acceleration(drive, {}, t, dt).x() == test::relative(exact).epsilon(1e-14));
}

TEST_CASE("a reversing drive turns when the axis has reached its speed, in either direction")
{
    const physics::Drive drive = physics::ReversingDrive{Vec3(33, 0, 0), 1.5};
    physics::DriveState state;
    CHECK_FALSE(physics::turn_if_due(drive, 1.4, 0.1, state));
    CHECK(physics::turn_if_due(drive, 1.5, 0.2, state));
    CHECK(physics::mean_acceleration(drive, state, 0.2, 0.1).x() == -33);
    CHECK_FALSE(physics::turn_if_due(drive, 1.6, 0.3, state));
    CHECK(physics::turn_if_due(drive, -1.5, 0.4, state));
    CHECK(state.switched_at == 0.4);
}

TEST_CASE("the time step is bound by the tightest limit")
{
    const physics::TimeStepOptions options{.largest = 1.0, .displacement = 0.8, .distortion = 0.5};
    CHECK(physics::time_step_limit({0, 0}, options).binding == "largest");
    CHECK(physics::time_step_limit({4, 1}, options).dt == test::relative(0.2));
    CHECK(physics::time_step_limit({4, 5}, options).binding == "distortion");
    // From rest, 0.8 cells at 5 cells/s2: 5 dt2 = 0.8.
    CHECK(physics::time_step_limit({0, 0, 5}, options).dt == test::relative(0.4));
    // Finite volumes: all fluid of a cell at 4 per second; from rest, at 2 per second squared.
    CHECK(physics::outflow_step_limit({.outflow = 4}, options).dt == test::relative(0.25));
    CHECK(physics::outflow_step_limit({.outflow_growth = 4}, options).dt == test::relative(0.5));
    CHECK(physics::outflow_step_limit({.displacement = 1}, options).binding == "largest");
    // A quarter of a width of 4 mm at 0.1 m/s; from rest under 10 m/s2: 10 dt2 = 1 mm.
    CHECK(physics::grain_move_limit(0.25, 4e-3, 0.1, 0.0) == test::relative(0.01));
    CHECK(physics::grain_move_limit(0.25, 4e-3, 0.0, 10.0) == test::relative(0.01));
    CHECK(std::isinf(physics::grain_move_limit(0.25, 0.0, 1.0, 10.0)));
}

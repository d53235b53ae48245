// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Balls on walls of triangles, at rest and moving, against exact statics, exact motion and analytic walls (NUMERICS D 44).
#include "tests/support/relative.hpp"
#include "tests/support/rolling_ball.hpp"
#include "tests/support/triangles.hpp"
#include <doctest/doctest.h>

using physics::WallMotion;
using test::Triangles, test::Vec3;

namespace {

constexpr double g = 9.81;
constexpr double radius = 1e-3;
const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500;

/// Force on a ball at rest, from one tiny step [N].
Vec3 static_force(const Triangles& triangles, const Vec3& centre, double stiffness)
{
    const double step = 1e-9;
    physics::ParticleDynamics dynamics({}, test::material(stiffness, 1.0, 0.5), {}, step);
    dynamics.add_surface(test::surface(triangles));
    dynamics.particles.add(test::sphere(0, centre, radius));
    test::run(dynamics, Vec3::Zero(), 1);
    return dynamics.particles.mass[0] / step * dynamics.particles.velocity_of(0);
}

/// How far the contacts of a ball are from carrying its weight, over its weight, where it is pressed in by `overlap` = 1e-5 m.
double out_of_balance(const Triangles& triangles, const Vec3& centre, double stiffness)
{
    return (static_force(triangles, centre, stiffness) - mass * g * Vec3::UnitZ()).norm() / (mass * g);
}

/// A pyramid (or a funnel, upside down) with `sides` sides and its tip at the origin.
Triangles pyramid(int sides, double height)
{
    Triangles triangles;
    for (int n = 0; n < sides; ++n) {
        const auto at = [&](int k) {
            const double angle = 2 * std::numbers::pi * (k % sides) / sides;
            return Vec3(5e-3 * std::cos(angle), 5e-3 * std::sin(angle), -height);
        };
        triangles.push_back({Vec3::Zero(), at(n), at(n + 1)});
    }
    return triangles;
}

/// A ball thrown at a wall with a spin: where it is, and how it moves, after some bounces.
std::array<double, 9> thrown(const std::vector<physics::Wall>& walls, const Triangles& triangles, const WallMotion& motion)
{
    const auto parameters = test::material(1e4, 0.8, 0.4);
    physics::ParticleDynamics dynamics({}, parameters, walls, physics::contact_time(parameters.walls[0], mass) / 50);
    if (!triangles.empty()) dynamics.add_surface(test::surface(triangles), motion);
    auto ball = test::sphere(0, Vec3(0.3e-3, 0.2e-3, 1.2 * radius), radius);
    ball.velocity = Vec3(0.1, -0.05, -0.3);
    ball.spin = Vec3(30, 50, 70);
    dynamics.particles.add(ball);
    physics::settle(dynamics, physics::DryMotion{Vec3(0, 0, -g)}, int(0.05 / dynamics.step()), core::SerialTeam{}, 0.0);
    return test::state(dynamics.particles).at(0);
}

double difference(const std::array<double, 9>& a, const std::array<double, 9>& b)
{
    double greatest = 0;
    for (std::size_t n = 0; n < 9; ++n) greatest = std::max(greatest, std::abs(a[n] - b[n]) / (n < 3 ? 1e-3 : n < 6 ? 0.1 : 100.0));
    return greatest;
}

/// Balls in a tumbling box of triangles.
std::map<std::int64_t, std::array<double, 9>> tumbled(double skin, double near_skin)
{
    auto parameters = test::material(1000, 0.6, 0.5);
    parameters.skin = skin;
    parameters.near_skin = near_skin;
    const double size = 18e-3;
    Triangles box;
    for (int a = 0; a < 3; ++a)
        for (const double at : {-0.5 * size, 0.5 * size}) {
            const Vec3 one = size * Vec3::Unit((a + 1) % 3), two = size * Vec3::Unit((a + 2) % 3);
            const auto face = test::sheet(at * Vec3::Unit(a) - 0.5 * (one + two), one, two);
            box.insert(box.end(), face.begin(), face.end());
        }
    WallMotion motion;
    motion.angular_velocity = Vec3(15, 10, 5);
    motion.amplitude = Vec3(1e-3, 0, 0);
    motion.angular_frequency = 200;
    physics::ParticleDynamics dynamics({}, parameters, {}, 1e-5);
    dynamics.add_surface(test::surface(box), motion);
    for (const auto& ball : test::loose_lattice(48, 4, 4, Vec3(-6.4e-3, -6.4e-3, -6e-3), 0.3)) dynamics.particles.add(ball);
    physics::settle(dynamics, physics::DryMotion{Vec3(0, 0, -g)}, 3000, core::SerialTeam{}, 0.0);
    for (int i = 0; i < dynamics.particles.owned; ++i) CHECK(dynamics.particles.position_of(i).norm() < 0.9 * size);
    return test::state(dynamics.particles);
}

} // namespace

TEST_CASE("a ball rests in a shallow groove, on a knife edge, on a tip and in a funnel as its weight asks")
{
    // stiff enough for an overlap of 1e-5 m under its weight; 1e-10 is wanted, rounding of the overlap is 1e-16 m
    const double overlap = 1e-5, stiffness = mass * g / overlap, degree = std::numbers::pi / 180;
    for (const double half : {10 * degree, 45 * degree, 70 * degree}) {
        const double up = std::cos(half), aside = std::sin(half);
        Triangles groove = test::sheet(Vec3(-5e-3, 0, 0), Vec3(10e-3, 0, 0), 5e-3 * Vec3(0, up, aside));
        const auto other = test::sheet(Vec3(-5e-3, 0, 0), Vec3(10e-3, 0, 0), 5e-3 * Vec3(0, -up, aside));
        groove.insert(groove.end(), other.begin(), other.end());
        CHECK(out_of_balance(groove, Vec3(1e-3, 0, (radius - overlap) / up), stiffness / (2 * up)) < 1e-10);
        for (auto& corners : groove)
            for (auto& x : corners) x[2] = -x[2];
        CHECK(out_of_balance(groove, Vec3(1e-3, 0, radius - overlap), stiffness) < 1e-10); // now an edge
        CHECK(out_of_balance(groove, Vec3(-0.2e-3, 0, radius - overlap), stiffness) < 1e-10);
    }
    for (const int sides : {3, 5, 12}) {
        CHECK(out_of_balance(pyramid(sides, 4e-3), Vec3(0, 0, radius - overlap), stiffness) < 1e-10);
        const double height = 4e-3, inner = 5e-3 * std::cos(std::numbers::pi / sides), up = inner / std::hypot(inner, height);
        CHECK(out_of_balance(pyramid(sides, -height), Vec3(0, 0, (radius - overlap) / up), stiffness / (sides * up)) < 1e-10);
    }
}

TEST_CASE("both sides of a sheet, its rim and its corners push a ball away from it, once")
{
    const Triangles plate = test::sheet(Vec3(-5e-3, -5e-3, 0), Vec3(10e-3, 0, 0), Vec3(0, 10e-3, 0));
    const double depth = radius - 1e-5;
    for (const Vec3& foot : {Vec3(0, 0, 0), Vec3(1e-3, 1e-3, 0), Vec3(1e-3, -2e-3, 0)}) // inside, and on the joint of its triangles
        for (const double side : {1.0, -1.0})
            CHECK((static_force(plate, foot + side * depth * Vec3::UnitZ(), 1000) - side * 0.01 * Vec3::UnitZ()).norm() < 1e-10);
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(1, 0, -0.3)}) {
        const Vec3 out = way.normalized();
        CHECK((static_force(plate, Vec3(5e-3, 1e-3, 0) + depth * out, 1000) - 0.01 * out).norm() < 1e-10);
    }
    const Vec3 out = Vec3(1, 2, 0.5).normalized();
    CHECK((static_force(plate, Vec3(5e-3, 5e-3, 0) + depth * out, 1000) - 0.01 * out).norm() < 1e-10);
}

TEST_CASE("a thin blade pushes from the side where the ball is")
{
    const double thickness = 0.05e-3;
    Triangles blade = test::sheet(Vec3(-5e-3, -5e-3, 0), Vec3(10e-3, 0, 0), Vec3(0, 10e-3, 0));
    for (const auto& [a, b, c] : test::sheet(Vec3(-5e-3, -5e-3, -thickness), Vec3(0, 10e-3, 0), Vec3(10e-3, 0, 0)))
        blade.push_back({a, b, c});
    CHECK((static_force(blade, Vec3(1e-3, 2e-3, 0.9 * radius), 1000) - 0.1 * Vec3::UnitZ()).norm() < 1e-10);
    CHECK((static_force(blade, Vec3(1e-3, 2e-3, -thickness - 0.9 * radius), 1000) + 0.1 * Vec3::UnitZ()).norm() < 1e-10);
}

TEST_CASE("a ball rolling round inside a cylinder of long triangles keeps its energy")
{
    for (const int around : {32, 64, 128})
        CHECK(test::RollingBall{}.roll({}, test::surface(test::long_cylinder(25e-3, 40e-3, around))).energy_error < 1e-5); // 1e-3 is wanted
}

TEST_CASE("ten thousand joints of a plane take no energy from a rolling ball")
{
    // 1e-6 for each joint is wanted; a plane gives none, and only rounding is left
    const double cell = 0.4e-3, speed = 1.5, stiffness = 1e5;
    const int cells = 5000;
    Triangles plane;
    for (int n = 0; n < cells; ++n)
        test::add_quad(plane, Vec3(n * cell, -3e-3, 0), Vec3((n + 1) * cell, -3e-3, 0), Vec3((n + 1.3) * cell, 3e-3, 0),
                       Vec3((n + 0.3) * cell, 3e-3, 0));
    const auto parameters = test::material(stiffness, 1.0, 0.8);
    physics::ParticleDynamics dynamics({}, parameters, {}, physics::contact_time(parameters.walls[0], mass) / 25);
    dynamics.add_surface(test::surface(plane));
    const double press = mass * g / stiffness;
    auto ball = test::sphere(0, Vec3(1e-3, 0.1e-3, radius - press), radius);
    ball.velocity = Vec3(speed, 0, 0);
    ball.spin = Vec3(0, speed / (radius - press), 0);
    dynamics.particles.add(ball);
    test::run(dynamics, Vec3(0, 0, -g), int((cells * cell - 3e-3) / speed / dynamics.step()));
    const auto& p = dynamics.particles;
    CHECK(p.position[0][0] > 0.99 * cells * cell);
    CHECK(std::abs(p.velocity[0][0] - speed) < 1e-9 * speed);
    CHECK(std::abs(p.spin[1][0] - ball.spin[1]) < 1e-9 * ball.spin[1]);
}

TEST_CASE("a sheet of triangles is a plane, at rest and moving")
{
    const Triangles sheet = test::sheet(Vec3(-50e-3, -40e-3, 0), Vec3(103e-3, 3e-3, 0), Vec3(-5e-3, 90e-3, 0));
    WallMotion still, sliding, shaking, tilting;
    sliding.velocity = Vec3(0.2, 0.1, 0);
    shaking.amplitude = Vec3(0.1e-3, 0, 0.3e-3);
    shaking.angular_frequency = 300;
    tilting.axis_point = Vec3(20e-3, 0, 0);
    tilting.angular_velocity = Vec3(1, -2, 3);
    for (const WallMotion& motion : {still, sliding, shaking, tilting}) {
        const auto analytic = thrown({physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ(), motion}}, {}, {});
        CHECK(difference(thrown({}, sheet, motion), analytic) < 1e-9); // rounding, grown by some bounces
    }
}

TEST_CASE("a turning cylinder of triangles drags a ball as the analytic one does")
{
    const double drum = 20e-3;
    WallMotion turning;
    turning.axis_point = Vec3(0, 0, drum);
    turning.angular_velocity = Vec3(-8, 0, 0);
    Triangles triangles = test::long_cylinder(drum, 60e-3, 128);
    for (auto& corners : triangles)
        for (auto& x : corners) x += Vec3(-30e-3, 0, drum);
    const auto analytic =
        thrown({physics::CylinderWall{turning.axis_point, Vec3::UnitX(), drum, physics::WallSide::inside, turning}}, {}, {});
    CHECK(difference(thrown({}, triangles, turning), analytic) <
          2e-3); // patches are off by 1e-7 of the radius; impacts and slip magnify it
}

TEST_CASE("how far lists reach changes no bit of what a tumbling box does, and no ball leaves it")
{
    const auto usual = tumbled(0.0, 0.0);
    CHECK(tumbled(0.1e-3, 0.01e-3) == usual);
    CHECK(tumbled(2e-3, 1e-3) == usual);
}

TEST_CASE("triangles that make no surface are refused by their numbers")
{
    const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const auto message = [](const Triangles& triangles) {
        try {
            (void)physics::joined_triangles(triangles);
        } catch (const core::ConfigError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(message({{o, x, y}, {o, y, z}}).empty());
    CHECK(message({{o, x, y}, {o, x, Vec3(2 * x)}}).starts_with("triangle 2 of 2 at (0 0 0) m has no area"));
    CHECK(message({{o, x, y}, {o, x, z}, {o, x, Vec3(-y)}}).starts_with("triangles 1, 2 and 3 share the edge at (0 0 0) m"));
    Triangles twisted; // a strip of three quads that is joined to itself upside down
    const auto rung = [&](int k) {
        return std::array<Vec3, 2>{Vec3(std::cos(2.1 * k), std::sin(2.1 * k), 0.2 * k),
                                   Vec3(std::cos(2.1 * k), std::sin(2.1 * k), 1 + 0.2 * k)};
    };
    for (int k = 0; k < 2; ++k) test::add_quad(twisted, rung(k)[0], rung(k + 1)[0], rung(k + 1)[1], rung(k)[1]);
    test::add_quad(twisted, rung(2)[0], rung(0)[1], rung(0)[0], rung(2)[1]);
    CHECK(message(twisted).find("join the two sides of the surface into one") != std::string::npos);
}

TEST_CASE("corners that differ by rounding are joined, and triangles turned to the side of their neighbours")
{
    const double off = 1e-8;
    const Triangles loose{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(1, off, 0), Vec3(0, 1, off), Vec3(1, 1, 0)}};
    const auto mesh = physics::joined_triangles(loose);
    CHECK(mesh.vertices.size() == 4);
    const auto normal = [&](std::size_t t) {
        const auto [a, b, c] = mesh.triangles[t];
        const auto at = [&](int n) { return mesh.vertices[std::size_t(n)]; };
        return (at(b) - at(a)).cross(at(c) - at(a));
    };
    CHECK(normal(0).dot(normal(1)) > 0);
}

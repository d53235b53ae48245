// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Balls on planes and cylinders that move, against exact motion.
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using physics::CylinderWall, physics::PlaneWall, physics::WallMotion;
using test::Vec3;

namespace {

constexpr double g = 9.81;
constexpr double radius = 1e-3;
const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500;

void run_from(physics::ParticleDynamics& dynamics, const Vec3& gravity, int steps, double time)
{
    physics::settle(dynamics, physics::DryMotion{gravity}, steps, core::SerialTeam{}, time);
}

WallMotion going(const Vec3& velocity)
{
    WallMotion motion;
    motion.velocity = velocity;
    return motion;
}

WallMotion turning(const Vec3& axis_point, const Vec3& angular_velocity)
{
    WallMotion motion;
    motion.axis_point = axis_point;
    motion.angular_velocity = angular_velocity;
    return motion;
}

/// A ball that hits a floor obliquely: its velocity and spin afterwards, seen from the floor.
std::array<double, 9> after_impact(const Vec3& floor_velocity)
{
    const auto parameters = test::material(1e5, 0.7, 0.3);
    const double step = physics::contact_time(parameters.walls[0], mass) / 50;
    physics::ParticleDynamics dynamics({}, parameters, {PlaneWall{Vec3::Zero(), Vec3::UnitZ(), going(floor_velocity)}}, step);
    auto ball = test::sphere(0, Vec3(0, 0, radius + 1e-6), radius);
    ball.velocity = Vec3(0.4, 0, -1) + floor_velocity;
    dynamics.particles.add(ball);
    run_from(dynamics, Vec3::Zero(), 80, 0.0);
    auto state = test::state(dynamics.particles).at(0);
    for (std::size_t a = 0; a < 3; ++a) {
        state[a] -= 80 * step * floor_velocity[int(a)];
        state[3 + a] -= floor_velocity[int(a)];
    }
    return state;
}

/// Speed that a ball at rest has taken over from a wall that slides below it with `speed`, when it has come to roll.
double dragged_speed(const physics::Wall& wall, const Vec3& foot, double speed)
{
    const double friction = 0.3, stiffness = 1e5;
    const auto parameters = test::material(stiffness, 0.5, friction);
    const double step = physics::contact_time(parameters.walls[0], mass) / 50, time = 2 * speed / (7 * friction * g);
    physics::ParticleDynamics dynamics({}, parameters, {wall}, step);
    dynamics.particles.add(test::sphere(0, foot + Vec3(0, 0, radius - mass * g / stiffness), radius));
    run_from(dynamics, Vec3(0, 0, -g), int(0.5 * time / step), 0.0);
    CHECK(dynamics.particles.velocity[0][0] == test::relative(friction * g * 0.5 * time).epsilon(1e-3)); // still slipping
    run_from(dynamics, Vec3(0, 0, -g), int(2.0 * time / step), int(0.5 * time / step) * step);
    return dynamics.particles.velocity[0][0];
}

/// Balls in a box whose floor shakes and whose roof turns.
std::map<std::int64_t, std::array<double, 9>> shaken_balls(double skin, double near_skin)
{
    auto parameters = test::material(1000, 0.6, 0.5);
    parameters.skin = skin;
    parameters.near_skin = near_skin;
    WallMotion shaking;
    shaking.amplitude = Vec3(0, 0, 2e-3);
    shaking.angular_frequency = 2 * std::numbers::pi * 50;
    WallMotion turn = turning(Vec3(8e-3, 0, 25e-3), Vec3(0, 20, 0));
    turn.start = 0.01;
    turn.stop = 0.02;
    std::vector<physics::Wall> walls{
        PlaneWall{Vec3::Zero(), Vec3::UnitZ(), shaking}, PlaneWall{Vec3(0, 0, 20e-3), -Vec3::UnitZ(), turn},
        CylinderWall{Vec3(8e-3, 8e-3, 0), Vec3::UnitZ(), 16e-3, physics::WallSide::inside, turning(Vec3(8e-3, 9e-3, 0), Vec3(0, 0, 30))}};
    physics::ParticleDynamics dynamics({}, parameters, walls, 1e-5);
    for (const auto& ball : test::loose_lattice(75, 5, 5, Vec3(0, 0, 3e-3), 0.5)) dynamics.particles.add(ball);
    run_from(dynamics, Vec3(0, 0, -g), 3000, 0.0);
    return test::state(dynamics.particles);
}

} // namespace

TEST_CASE("an impact does not depend on how fast wall and ball go together")
{
    const auto still = after_impact(Vec3::Zero()), moved = after_impact(Vec3(2, -3, 5));
    for (std::size_t n = 0; n < 9; ++n)
        CHECK(std::abs(moved[n] - still[n]) < 1e-8 * (n < 3 ? radius : n < 6 ? 1.0 : 1000.0)); // rounding: ways of 4 mm, overlaps of 40 um
}

TEST_CASE("a vibrating plate throws a ball as the law of impact says")
{
    // v' = -e (v - V) + V with the plate's speed V where they meet; the error is of the order of the contact's share of a period
    const double e = 0.8, omega = 2 * std::numbers::pi * 10, amplitude = 2e-3;
    const auto parameters = test::material(1e9, e, 0.0);
    const double contact = physics::contact_time(parameters.walls[0], mass), step = contact / 200;
    for (const double phase : {0.3, 2.0, 4.0}) {
        WallMotion shaking;
        shaking.amplitude = Vec3(0, 0, amplitude);
        shaking.angular_frequency = omega;
        shaking.phase = phase;
        physics::ParticleDynamics dynamics({}, parameters, {PlaneWall{Vec3::Zero(), Vec3::UnitZ(), shaking}}, step);
        auto ball = test::sphere(0, Vec3(0, 0, radius), radius);
        ball.velocity = Vec3(0, 0, -1);
        dynamics.particles.add(ball);
        run_from(dynamics, Vec3::Zero(), 250, 0.0);
        const double plate = amplitude * omega * std::cos(phase);
        CHECK(dynamics.particles.velocity[2][0] == test::relative(e * (1 + plate) + plate).epsilon(1e-3)); // de = 8e-4 of 200 steps
    }
}

TEST_CASE("a sliding belt and a turning drum drag a ball until it rolls with 2/7 of their speed")
{
    const double speed = 0.1, drum = 100; // so large that the ball, which climbs by 0.1 mm, feels no slope
    CHECK(dragged_speed(PlaneWall{Vec3::Zero(), Vec3::UnitZ(), going(Vec3(speed, 0, 0))}, Vec3::Zero(), speed) ==
          test::relative(2.0 / 7.0 * speed).epsilon(1e-4));
    const Vec3 axis = Vec3::UnitY(), centre(0, 0, drum);
    const CylinderWall inside{centre, axis, drum, physics::WallSide::inside, turning(centre, -speed / drum * axis)};
    CHECK(dragged_speed(inside, Vec3::Zero(), speed) == test::relative(2.0 / 7.0 * speed).epsilon(1e-4));
    const CylinderWall outside{-centre, axis, drum, physics::WallSide::outside, turning(-centre, speed / drum * axis)};
    CHECK(dragged_speed(outside, Vec3::Zero(), speed) == test::relative(2.0 / 7.0 * speed).epsilon(1e-4));
}

TEST_CASE("a ball that rolls on a turntable goes in circles with 2/7 of its rate")
{
    // Weltner (1987), Central drift of freely moving balls on rotating disks: the circle's rate is 2/7 of the table's
    const double rate = 10, stiffness = 1e5, friction = 5.0;
    const auto parameters = test::material(stiffness, 0.5, friction);
    const double step = physics::contact_time(parameters.walls[0], mass) / 50;
    const Vec3 start(20e-3, 0, radius - mass * g / stiffness);
    physics::ParticleDynamics dynamics({}, parameters, {PlaneWall{Vec3::Zero(), Vec3::UnitZ(), turning(Vec3::Zero(), Vec3(0, 0, rate))}},
                                       step);
    auto ball = test::sphere(0, start, radius);
    ball.velocity = Vec3(0, 0.1, 0);
    // no slip: v + spin x (-R z) = rate z x r
    const Vec3 slip = Vec3(0, 0, rate).cross(Vec3(start[0], 0, 0)) - ball.velocity;
    ball.spin = Vec3(-slip[1], slip[0], 0) * -1.0 / start[2];
    dynamics.particles.add(ball);
    const double period = 2 * std::numbers::pi / (2.0 / 7.0 * rate), round = 0.1 / (2.0 / 7.0 * rate);
    run_from(dynamics, Vec3(0, 0, -g), int(0.5 * period / step), 0.0);
    CHECK((dynamics.particles.position_of(0) - start - Vec3(-2 * round, 0, 0)).norm() <
          2e-3 * round); // the spring's slack and its first swing
}

TEST_CASE("a paddle throws a ball without friction outwards as a cosine hyperbolicus")
{
    const double rate = 20, r0 = 10e-3, stiffness = 1e5;
    const auto parameters = test::material(stiffness, 0.5, 0.0);
    const double step = physics::contact_time(parameters.walls[0], mass) / 50, time = 2 / rate;
    physics::ParticleDynamics dynamics({}, parameters, {PlaneWall{Vec3::Zero(), Vec3::UnitY(), turning(Vec3::Zero(), Vec3(0, 0, rate))}},
                                       step);
    auto ball = test::sphere(0, Vec3(r0, radius, 0), radius);
    ball.velocity = Vec3(0, 0, rate).cross(ball.position);
    dynamics.particles.add(ball);
    const int steps = int(time / step);
    run_from(dynamics, Vec3::Zero(), steps, 0.0);
    const double reached = dynamics.particles.position_of(0).head<2>().norm(), along = r0 * std::cosh(rate * steps * step);
    CHECK(reached == test::relative(std::hypot(along, radius)).epsilon(1e-4)); // overlap mass 2 rate dr/dt / k = 1e-5 of r
}

TEST_CASE("walls stand still before they start and after they stop, and are where the time says")
{
    WallMotion motion = turning(Vec3(1, 0, 0), Vec3(0, 0, 2));
    motion.velocity = Vec3(0, 3, 0);
    motion.amplitude = Vec3(0, 0, 0.5);
    motion.angular_frequency = 7;
    motion.phase = 0.4;
    motion.start = 1;
    motion.stop = 1.5;
    CHECK((motion.at(0.7).place(Vec3(2, 2, 2)) - Vec3(2, 2, 2)).norm() == 0.0);
    CHECK(motion.at(0.7).velocity_at(Vec3(2, 2, 2)).norm() == 0.0);
    CHECK(motion.at(1.5).velocity_at(Vec3(2, 2, 2)).norm() == 0.0);
    CHECK((motion.at(9).place(Vec3(2, 2, 2)) - motion.at(1.5).place(Vec3(2, 2, 2))).norm() == 0.0);
    const double t = 1.3, h = 1e-6;
    const Vec3 own(2, 2, 2), x = motion.at(t).place(own);
    const Vec3 difference = (motion.at(t + h).place(own) - motion.at(t - h).place(own)) / (2 * h);
    CHECK((motion.at(t).velocity_at(x) - difference).norm() < 1e-8); // rounding of the difference
    CHECK((motion.at(t).own(x) - own).norm() < 1e-14);
    const auto from = motion.at(1.1), to = motion.at(1.4);
    const double way = physics::way_between(from, to, from.place(own) - Vec3::Constant(0.01), from.place(own) + Vec3::Constant(0.01));
    const double gone = (to.place(own) - from.place(own)).norm();
    CHECK(way >= gone);
    CHECK(way < 3 * gone);
}

TEST_CASE("how far lists reach changes no bit of what moving walls do")
{
    const auto usual = shaken_balls(0.0, 0.0);
    CHECK(shaken_balls(0.1e-3, 0.01e-3) == usual);
    CHECK(shaken_balls(2e-3, 1e-3) == usual);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Forces, torques and power of walls against the momentum and the energy of the particles.
#include "core/base/team.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/triangles.hpp"
#include <doctest/doctest.h>

using physics::WallMotion;
using test::Vec3;

namespace {

constexpr double g = 9.81, radius = 1e-3;

Vec3 force_of(const physics::WallLoad& load) { return {load.sum[0].value(), load.sum[1].value(), load.sum[2].value()}; }
Vec3 torque_of(const physics::WallLoad& load) { return {load.sum[3].value(), load.sum[4].value(), load.sum[5].value()}; }

struct Momenta {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

Momenta momenta_of(const core::ParticleSet& p)
{
    Momenta sum;
    for (int i = 0; i < p.owned; ++i) {
        const auto n = std::size_t(i);
        sum.linear += p.mass[n] * p.velocity_of(i);
        sum.angular += p.mass[n] * p.position_of(i).cross(p.velocity_of(i)) + p.inertia[n] * p.spin_of(i);
    }
    return sum;
}

/// 50 balls between a tilting floor, a roof, a turning cylinder and a swinging sheet of triangles.
physics::ParticleDynamics shaken(const physics::ParticleParameters& parameters)
{
    WallMotion tilting, turning, swinging;
    tilting.axis_point = Vec3(8e-3, 8e-3, 0);
    tilting.angular_velocity = Vec3(2, 1, 0);
    turning.axis_point = Vec3(8e-3, 8e-3, 0);
    turning.angular_velocity = Vec3(0, 0, 30);
    swinging.axis_point = Vec3(8e-3, 8e-3, 12e-3);
    swinging.angular_velocity = Vec3(0, 0, 20);
    physics::ParticleDynamics dynamics(
        {}, parameters,
        {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ(), tilting, 0}, physics::PlaneWall{Vec3(0, 0, 22e-3), -Vec3::UnitZ(), {}, 1},
         physics::CylinderWall{Vec3(8e-3, 8e-3, 0), Vec3::UnitZ(), 15e-3, physics::WallSide::inside, turning, 2}},
        1e-5);
    dynamics.add_surface(test::surface(test::sheet(Vec3(1e-3, 8e-3, 12e-3), Vec3(14e-3, 0, 0), Vec3(0, 0, 8e-3))), swinging, 3);
    dynamics.report_walls(4);
    for (const auto& ball : test::loose_lattice(50, 5, 5, Vec3(0, 0, 3e-3), 0.5)) dynamics.particles.add(ball);
    return dynamics;
}

} // namespace

TEST_CASE("what walls receive is what the particles lose: momentum and angular momentum, to rounding")
{
    physics::ParticleDynamics dynamics = shaken(test::material(1000, 0.6, 0.5));
    const std::array<Vec3, 4> points{Vec3(8e-3, 8e-3, 0), Vec3::Zero(), Vec3(8e-3, 8e-3, 0), Vec3(8e-3, 8e-3, 12e-3)};
    double time = 0, greatest = 0;
    for (int batch = 0; batch < 30; ++batch) {
        const Momenta before = momenta_of(dynamics.particles);
        physics::settle(dynamics, physics::DryMotion{}, 50, core::SerialTeam{}, time);
        time += 50 * dynamics.step();
        const Momenta after = momenta_of(dynamics.particles);
        Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
        const auto loads = dynamics.loads();
        REQUIRE(dynamics.load_steps() == 50);
        for (std::size_t w = 0; w < 4; ++w) {
            linear += dynamics.step() * force_of(loads[w]);
            angular += dynamics.step() * (torque_of(loads[w]) + points[w].cross(force_of(loads[w])));
        }
        greatest = std::max(greatest, linear.norm());
        CHECK((after.linear - before.linear + linear).norm() < 1e-16);    // [N s]; momenta are 1e-5, impulses 1e-6
        CHECK((after.angular - before.angular + angular).norm() < 1e-18); // arms of 1e-2 m
    }
    CHECK(greatest > 1e-7); // something happened
}

TEST_CASE("a ball at rest presses on its floor with its weight, and turns it about its point of reference")
{
    const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500, stiffness = 1000;
    const Vec3 point(-5e-3, 2e-3, 0);
    WallMotion still;
    still.axis_point = point;
    physics::ParticleDynamics dynamics({}, test::material(stiffness, 0.5, 0.5), {physics::PlaneWall{point, Vec3::UnitZ(), still, 0}}, 1e-6);
    dynamics.report_walls(1);
    dynamics.particles.add(test::sphere(0, Vec3(1e-3, 1e-3, radius - mass * g / stiffness), radius));
    test::run(dynamics, Vec3(0, 0, -g), 10);
    const Vec3 weight(0, 0, -mass * g), force = force_of(dynamics.loads()[0]) / 10, torque = torque_of(dynamics.loads()[0]) / 10;
    CHECK((force - weight).norm() < 1e-9 * mass * g); // rounding of the overlap
    CHECK((torque - (Vec3(1e-3, 1e-3, 0) - point).cross(weight)).norm() < 1e-9 * mass * g * 1e-2);
}

TEST_CASE("the power of a moving wall is what an elastic ball gains")
{
    const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500, speed = 0.5;
    const auto parameters = test::material(1e5, 1.0, 0.0);
    WallMotion rising;
    rising.velocity = Vec3(0, 0, speed);
    physics::ParticleDynamics dynamics({}, parameters, {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ(), rising, 0}},
                                       physics::contact_time(parameters.walls[0], mass) / 100);
    dynamics.report_walls(1);
    auto ball = test::sphere(0, Vec3(0, 0, radius + 1e-6), radius);
    ball.velocity = Vec3(0, 0, -1);
    dynamics.particles.add(ball);
    physics::settle(dynamics, physics::DryMotion{}, 150, core::SerialTeam{}, 0.0);
    const double after = dynamics.particles.velocity[2][0], work = dynamics.step() * dynamics.loads()[0].sum[6].value();
    CHECK(after == test::relative(1 + 2 * speed).epsilon(1e-5)); // error of third order of the impact
    CHECK(work == test::relative(0.5 * mass * (after * after - 1)).epsilon(1e-5));
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Rolling, twisting and cohesion against exact motion.
#include "tests/support/impact.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

constexpr double radius = 1e-3, g = 9.81, stiffness = 1e5;
const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500, overlap = mass * g / stiffness;

physics::ContactParameters rough(physics::RollingModel model, double rolling, double twisting)
{
    physics::ContactParameters p{stiffness, 2.0 / 7.0, 0.5, 0.8};
    p.rolling = model;
    p.rolling_friction = rolling;
    p.twisting_friction = twisting;
    return p;
}

physics::ParticleDynamics on_floor(const physics::ContactParameters& contact, const Vec3& velocity, const Vec3& spin)
{
    physics::ParticleParameters parameters;
    parameters.pairs = parameters.walls = {contact};
    physics::ParticleDynamics dynamics({}, parameters, {physics::PlaneWall{}}, physics::contact_time(contact, mass) / 50);
    auto ball = test::sphere(0, Vec3(0, 0, radius - overlap), radius);
    ball.velocity = velocity;
    ball.spin = spin;
    dynamics.particles.add(ball);
    return dynamics;
}

} // namespace

TEST_CASE("a rolling ball is slowed by 5/7 of rolling friction times gravity, with either model")
{
    // 7/5 m R^2 dw/dt = - mu_r R m g
    for (const auto model : {physics::RollingModel::constant, physics::RollingModel::spring}) {
        const double speed = 0.05, friction = 0.1, time = 0.02;
        auto dynamics = on_floor(rough(model, friction, 0.0), Vec3(speed, 0, 0), Vec3(0, speed / radius, 0));
        test::run(dynamics, Vec3(0, 0, -g), int(std::lround(time / dynamics.step())));
        // the spring of model C needs some time to reach its limit
        CHECK(dynamics.particles.velocity[0][0] == test::relative(speed - 5.0 / 7.0 * friction * g * time).epsilon(5e-3));
    }
}

TEST_CASE("a ball spinning about its normal is slowed by 5/2 of twisting friction times gravity over its radius")
{
    for (const auto model : {physics::RollingModel::constant, physics::RollingModel::spring}) {
        const double spin = 100, friction = 0.05, time = 0.02;
        auto dynamics = on_floor(rough(model, 0.0, friction), Vec3::Zero(), Vec3(0, 0, spin));
        test::run(dynamics, Vec3(0, 0, -g), int(std::lround(time / dynamics.step())));
        CHECK(dynamics.particles.spin[2][0] == test::relative(spin - 2.5 * friction * g / radius * time).epsilon(5e-3));
        CHECK(std::abs(dynamics.particles.velocity[0][0]) < 1e-12);
    }
}

TEST_CASE("a ball on a slope below rolling friction stays where it is with a spring, and creeps with a constant torque")
{
    // it rolls where tan(slope) > mu_r
    const double friction = 0.1;
    const auto way = [&](physics::RollingModel model, double slope) {
        auto dynamics = on_floor(rough(model, friction, 0.0), Vec3::Zero(), Vec3::Zero());
        test::run(dynamics, g * Vec3(slope, 0, -1), int(std::lround(0.2 / dynamics.step())));
        return dynamics.particles.position[0][0];
    };
    CHECK(std::abs(way(physics::RollingModel::spring, 0.09)) < 1e-3 * radius); // the springs give way a little
    CHECK(way(physics::RollingModel::spring, 0.12) == test::relative(5.0 / 14.0 * 0.02 * g * 0.04).epsilon(0.02));
    CHECK(way(physics::RollingModel::constant, 0.12) == test::relative(5.0 / 14.0 * 0.02 * g * 0.04).epsilon(0.02));
}

TEST_CASE("cohesion holds a ball under a ceiling up to two pi times adhesion and radius")
{
    for (const double share : {0.95, 1.05}) {
        const test::Solid glass{1e7, 0.25, 2500};
        physics::ParticleParameters parameters;
        auto contact = test::hertz(glass, glass, 0.2, 0.5);
        contact.cohesion = mass * g / (2 * std::numbers::pi * radius) / share;
        contact.impact_speed = 0.1;
        parameters.pairs = parameters.walls = {contact};
        const double step = physics::contact_time(contact, physics::ContactBody{mass, radius}) / 50;
        physics::ParticleDynamics dynamics({}, parameters, {physics::PlaneWall{Vec3::Zero(), -Vec3::UnitZ()}}, step);
        // at rest: 4/3 E sqrt(R) delta^(3/2) = 2 pi w R - m g
        const double spare = std::max(0.0, mass * g / share - mass * g);
        const double depth = std::pow(0.75 * spare / (contact.young_modulus * std::sqrt(radius)), 2.0 / 3.0);
        dynamics.particles.add(test::sphere(0, Vec3(0, 0, -radius + (share < 1 ? depth : 1e-8)), radius));
        test::run(dynamics, Vec3(0, 0, -g), 20000);
        if (share < 1) CHECK(dynamics.particles.position[2][0] + radius == test::relative(depth).epsilon(1e-6));
        else CHECK(dynamics.particles.position[2][0] < -1.5 * radius);
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Where the energy of particles goes is known to a millionth of it.
#include "tests/support/impact.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/triangles.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

struct Budget {
    double kinetic = 0.0, rotational = 0.0, potential = 0.0, elastic = 0.0, damping = 0.0, friction = 0.0, turning = 0.0, walls = 0.0;
    [[nodiscard]] double total() const { return kinetic + rotational + potential + elastic + damping + friction + turning - walls; }
};

Budget budget_of(const physics::ParticleDynamics& dynamics, const Vec3& gravity)
{
    const auto& p = dynamics.particles;
    Budget b;
    for (int i = 0; i < p.owned; ++i) {
        const auto k = std::size_t(i);
        const auto value = [&](int column) { return p.columns[std::size_t(column)][k]; };
        b.kinetic += 0.5 * p.mass[k] * p.velocity_of(i).squaredNorm();
        b.rotational += 0.5 * p.inertia[k] * p.spin_of(i).squaredNorm();
        b.potential -= p.mass[k] * gravity.dot(p.position_of(i));
        b.elastic += value(dynamics.energy().elastic);
        b.damping += value(dynamics.energy().damping);
        b.friction += value(dynamics.energy().friction);
        b.turning += value(dynamics.energy().turning);
        b.walls += value(dynamics.energy().walls);
    }
    return b;
}

physics::ParticleParameters booked(const physics::ContactParameters& contact)
{
    physics::ParticleParameters p;
    p.pairs = p.walls = {contact};
    p.energy_budget = physics::Budget::kept;
    return p;
}

/// Balls that fall into a tube and come to lie on its floor: the greatest error of the budget over the energy that they bring.
double greatest_error(const physics::ContactParameters& contact, double step, double time)
{
    const Vec3 gravity(0, 0, -9.81);
    const double width = 5 * 3.2e-3;
    physics::ParticleDynamics dynamics(
        {}, booked(contact), {physics::PlaneWall{}, physics::CylinderWall{Vec3(width / 2, width / 2, 0), Vec3::UnitZ(), 0.8 * width}},
        step);
    for (const auto& ball : test::loose_lattice(100, 5, 5, Vec3::Zero(), 1.0)) dynamics.particles.add(ball);
    const Budget start = budget_of(dynamics, gravity);
    double worst = 0.0;
    for (int n = 0; n < 20; ++n) {
        test::run(dynamics, gravity, int(std::lround(time / 20 / step)));
        const Budget now = budget_of(dynamics, gravity);
        worst = std::max(worst, std::abs(now.total() - start.total()) / (start.kinetic + start.rotational + start.potential));
        CHECK(now.damping >= 0.0);
        CHECK(now.friction > 0.0);
    }
    return worst;
}

/// Balls between a floor that turns and shakes, a roof, a turning cylinder and a swinging sheet of triangles: the greatest error of the
/// budget over the energy that they and the walls bring.
double shaken_error(const physics::ContactParameters& contact, double step)
{
    const Vec3 gravity(0, 0, -9.81), middle(8e-3, 8e-3, 12e-3);
    physics::WallMotion shaking, turning, swinging;
    shaking.axis_point = turning.axis_point = swinging.axis_point = middle;
    shaking.angular_velocity = Vec3(2, 1, 10);
    shaking.amplitude = Vec3(0, 3e-4, 5e-4);
    shaking.angular_frequency = 500;
    turning.angular_velocity = Vec3(0, 0, 30);
    swinging.angular_velocity = Vec3(0, 0, 20);
    swinging.amplitude = Vec3(0, 0, 5e-4);
    swinging.angular_frequency = 300;
    physics::ParticleDynamics dynamics(
        {}, booked(contact),
        {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ(), shaking}, physics::PlaneWall{Vec3(0, 0, 22e-3), -Vec3::UnitZ()},
         physics::CylinderWall{Vec3(8e-3, 8e-3, 0), Vec3::UnitZ(), 15e-3, physics::WallSide::inside, turning}},
        step);
    dynamics.add_surface(test::surface(test::sheet(Vec3(1e-3, 8e-3, 12e-3), Vec3(14e-3, 0, 0), Vec3(0, 0, 8e-3))), swinging);
    for (const auto& ball : test::loose_lattice(50, 5, 5, Vec3(0, 0, 3e-3), 0.5)) dynamics.particles.add(ball);
    const Budget start = budget_of(dynamics, gravity);
    const int batches = 20, steps = int(std::lround(0.02 / batches / step));
    double worst = 0.0;
    for (int n = 0; n < batches; ++n) {
        physics::settle(dynamics, physics::DryMotion{gravity}, steps, core::SerialTeam{}, n * steps * step);
        worst = std::max(worst, std::abs(budget_of(dynamics, gravity).total() - start.total()));
    }
    const Budget end = budget_of(dynamics, gravity);
    CHECK(end.walls > 0.0);
    return worst / (start.kinetic + start.rotational + start.potential + end.walls);
}

} // namespace

TEST_CASE("the budget of balls that fall into a tube closes to a millionth of what they bring, with every law")
{
    // what is left is that of springs which bend: the scheme itself, and goes with the square of the step
    const physics::ContactParameters linear{1000, 2.0 / 7.0, 0.7, 0.5};
    const test::Solid rubber{5e6, 0.4, 2000};
    auto hertz = test::hertz(rubber, rubber, 0.7, 0.5), general = hertz;
    general.rolling_friction = general.twisting_friction = 0.1;
    general.cohesion = 0.01;
    auto constant = general;
    constant.rolling = physics::RollingModel::constant;
    for (const auto& contact : {linear, hertz, general, constant}) {
        const double coarse = greatest_error(contact, 2e-6, 0.02), fine = greatest_error(contact, 2.5e-7, 0.02);
        CHECK(fine < 1e-6);
        CHECK(fine < coarse / 16);
    }
}

TEST_CASE("the budget closes with walls that move and shake, at second order in the step")
{
    const physics::ContactParameters linear{1000, 2.0 / 7.0, 0.7, 0.5};
    const test::Solid rubber{5e6, 0.4, 2000};
    auto general = test::hertz(rubber, rubber, 0.7, 0.5);
    general.rolling_friction = general.twisting_friction = 0.1;
    auto constant = general;
    constant.rolling = physics::RollingModel::constant;
    for (const auto& contact : {linear, general, constant}) {
        const double coarse = shaken_error(contact, 2e-6), fine = shaken_error(contact, 2.5e-7);
        CHECK(fine < 1e-6);
        CHECK(fine < coarse / 16);
    }
}

TEST_CASE("a belt gives a ball that it sets rolling twice what the ball keeps, and friction takes the other half")
{
    const double speed = 0.1, stiffness = 1e5, mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500, weight = mass * 9.81;
    const Vec3 gravity(0, 0, -9.81);
    physics::WallMotion running;
    running.velocity = Vec3(speed, 0, 0);
    physics::ParticleDynamics dynamics({}, booked({stiffness, 2.0 / 7.0, 0.5, 0.5}),
                                       {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ(), running}}, 1e-6);
    dynamics.particles.add(test::sphere(0, Vec3(0, 0, 1e-3 - weight / stiffness), 1e-3));
    const Budget start = budget_of(dynamics, gravity);
    physics::settle(dynamics, physics::DryMotion{gravity}, 10000, core::SerialTeam{}, 0.0); // it slides for 5.8 ms
    const Budget end = budget_of(dynamics, gravity);
    // it ends with 2/7 of the belt's speed and the spin of 5/7 of it; the impulse of the belt is 2/7 m V
    const double given = 2.0 / 7.0 * mass * speed * speed;
    CHECK(end.walls == test::relative(given).epsilon(1e-3)); // the last sliding goes over into a spring
    CHECK(end.kinetic + end.rotational == test::relative(0.5 * given).epsilon(1e-3));
    CHECK(end.friction + end.damping == test::relative(0.5 * given).epsilon(1e-3));
    const double held = 0.5 * weight * weight / stiffness; // by the spring from the start, before the first step books it
    CHECK(std::abs(end.total() - start.total() - held) < 1e-8 * given);
}

TEST_CASE("an impact takes from its energy what restitution and friction say, and books it by kind")
{
    const double e = 0.6, friction = 0.1, vn = 1.0, vt = 2.0, mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500;
    const physics::ContactParameters contact{1e6, 2.0 / 7.0, e, friction};
    physics::ParticleDynamics dynamics({}, booked(contact), {physics::PlaneWall{}}, physics::contact_time(contact, mass) / 20000);
    auto ball = test::sphere(0, Vec3(0, 0, 1e-3), 1e-3);
    ball.velocity = Vec3(vt, 0, -vn);
    dynamics.particles.add(ball);
    test::run(dynamics, Vec3::Zero(), 30000);
    const Budget b = budget_of(dynamics, Vec3::Zero());
    // first order in the step, 1/20000
    CHECK(b.damping == test::relative(0.5 * mass * vn * vn * (1 - e * e)).epsilon(2e-4));
    const double jump = friction * (1 + e) * vn;                                            // of the velocity; slip falls by 7/2 of it
    CHECK(b.friction == test::relative(mass * jump * (vt - 3.5 / 2 * jump)).epsilon(3e-3)); // the lever is shorter by the overlap
    CHECK(std::abs(b.elastic) < 1e-12 * b.kinetic);
    CHECK(b.turning == 0.0);
}

TEST_CASE("a heap at rest has spent all that it had, and a budget does not change it")
{
    const Vec3 gravity(0, 0, -9.81);
    physics::ContactParameters contact{1000, 2.0 / 7.0, 0.3, 0.5};
    contact.rolling_friction = contact.twisting_friction = 0.1;
    const auto run = [&](physics::Budget kept) {
        auto parameters = booked(contact);
        parameters.energy_budget = kept;
        physics::ParticleDynamics dynamics({}, parameters, {physics::PlaneWall{}}, 1e-5);
        for (const auto& ball : test::loose_lattice(27, 3, 3, Vec3::Zero(), 0.1)) dynamics.particles.add(ball);
        test::run(dynamics, gravity, 40000);
        return dynamics;
    };
    const auto with = run(physics::Budget::kept);
    CHECK(test::state(with.particles) == test::state(run(physics::Budget::none).particles));
    const Budget b = budget_of(with, gravity);
    CHECK(b.kinetic + b.rotational < 1e-9 * b.potential);
    CHECK(b.turning > 0.0);
}

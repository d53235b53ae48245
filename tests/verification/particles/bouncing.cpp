// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Single particles and columns of particles against exact motion.
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/rolling_ball.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

const std::vector<physics::Wall> floor_wall{physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()}};

} // namespace

TEST_CASE("a ball bounces to the heights of its restitution")
{
    // h_k = (h0 - r) e^(2k) + r for a stiff floor (Garg et al. 2012, DEM01); 200 steps per contact leave de = 1e-3
    for (const double e : {0.9, 0.8, 0.5}) {
        const double radius = 0.1, drop = 0.5, mass = 4.0 / 3.0 * std::numbers::pi * 1e-3 * 2600;
        auto parameters = test::material(1e9, e, 0.0);
        const double step = physics::contact_time(parameters.walls[0], mass) / 200;
        physics::ParticleDynamics dynamics({}, parameters, floor_wall, step);
        dynamics.particles.add(test::sphere(0, Vec3(0, 0, drop), radius, 2600));
        double top = 0.0;
        bool rising = false;
        for (int bounce = 0; bounce < 2;) {
            test::run(dynamics, Vec3(0, 0, -9.81), 50);
            const double v = dynamics.particles.velocity[2][0];
            top = std::max(rising ? top : 0.0, dynamics.particles.position[2][0]);
            if (rising && v < 0) {
                const double wanted = (drop - radius) * std::pow(e, 2 * ++bounce) + radius;
                CHECK(std::abs(top - wanted) < 5e-3 * wanted);
            }
            rising = v > 0;
        }
    }
}

TEST_CASE("two stacked balls between walls move as their exact solution")
{
    // matrix exponential of the linear system (set-up of Garg et al. 2012, DEM03); eight digits are printed
    const double exact[][3] = {{1e-5, 0.44976154, 1.35047508},
                               {5e-5, 0.44447794, 1.36078192},
                               {2e-4, 0.42458163, 1.37309069},
                               {5e-4, 0.43623747, 1.37913934},
                               {1e-3, 0.42712796, 1.38355313}};
    const double step = 2e-8;
    const std::vector<physics::Wall> walls{physics::PlaneWall{Vec3::Zero(), Vec3::UnitY()},
                                           physics::PlaneWall{Vec3(0, 1.8e-3, 0), -Vec3::UnitY()}};
    physics::ParticleDynamics dynamics({}, test::material(1000, 1.0, 0.0), walls, step);
    dynamics.particles.add(test::sphere(0, Vec3(0, 0.45e-3, 0), 0.5e-3, 20000));
    dynamics.particles.add(test::sphere(1, Vec3(0, 1.35e-3, 0), 0.5e-3, 10000));
    double time = 0.0;
    for (const auto& [t, low, high] : exact) {
        test::run(dynamics, Vec3(0, -9.81, 0), int(std::lround((t - time) / step)));
        time = t;
        const auto& y = dynamics.particles.position[1];
        CHECK(std::abs(y[std::size_t(test::place(dynamics.particles, 0))] - 1e-3 * low) < 2e-11);
        CHECK(std::abs(y[std::size_t(test::place(dynamics.particles, 1))] - 1e-3 * high) < 2e-11);
    }
}

TEST_CASE("a slipping ball comes to roll with 5/7 of its speed")
{
    const double radius = 1e-3, u0 = 0.1, friction = 0.3, g = 9.81, stiffness = 1e5;
    const auto parameters = test::material(stiffness, 0.5, friction);
    const double mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500, overlap = mass * g / stiffness;
    const double step = physics::contact_time(parameters.walls[0], mass) / 50, time = 2 * u0 / (7 * friction * g);
    physics::ParticleDynamics dynamics({}, parameters, floor_wall, step);
    auto ball = test::sphere(0, Vec3(0, 0, radius - overlap), radius);
    ball.velocity = Vec3(u0, 0, 0);
    dynamics.particles.add(ball);
    test::run(dynamics, Vec3(0, 0, -g), int(0.5 * time / step));
    // still slipping: u = u0 - mu g t
    CHECK(dynamics.particles.velocity[0][0] == test::relative(u0 - friction * g * 0.5 * time).epsilon(1e-3));
    test::run(dynamics, Vec3(0, 0, -g), int(2.0 * time / step));
    CHECK(dynamics.particles.velocity[0][0] == test::relative(5.0 / 7.0 * u0).epsilon(1e-4)); // overlap / radius = 1e-6
    CHECK(dynamics.particles.spin[1][0] * radius == test::relative(5.0 / 7.0 * u0).epsilon(1e-4));
}

TEST_CASE("a column of 20 balls comes to rest with the overlaps of its weight")
{
    const int n = 20;
    const double radius = 1e-3, stiffness = 1000, g = 9.81, mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500;
    const double step = 0.02 * std::sqrt(mass / stiffness);
    physics::ParticleDynamics dynamics({}, test::material(stiffness, 0.05, 0.5), floor_wall, step);
    for (int k = 0; k < n; ++k) dynamics.particles.add(test::sphere(k, Vec3(0, 0, radius * (1 + 2 * k)), radius));
    test::run(dynamics, Vec3(0, 0, -g), 200000); // the slowest mode falls by exp(-20)
    std::vector<double> z(n);
    for (int k = 0; k < n; ++k) z[std::size_t(k)] = dynamics.particles.position[2][std::size_t(test::place(dynamics.particles, k))];
    CHECK(std::abs(radius - z[0] - n * mass * g / stiffness) < 1e-8 * n * mass * g / stiffness);
    for (int k = 1; k < n; ++k) {
        const double wanted = (n - k) * mass * g / stiffness;
        CHECK(std::abs(2 * radius - (z[std::size_t(k)] - z[std::size_t(k) - 1]) - wanted) < 1e-8 * n * mass * g / stiffness);
    }
}

TEST_CASE("a ball rolling round inside a cylinder keeps its energy")
{
    const test::RollingBall ball{.at = 0.0};
    const auto end = ball.roll({physics::CylinderWall{Vec3::Zero(), Vec3::UnitX(), ball.cylinder}});
    CHECK(std::abs(end.at) < 1e-12);
    CHECK(end.energy_error < 1e-3); // the energy in the springs, mass v^4 / (2 k arm^2), is 3e-4 of it
}

TEST_CASE("an oblique impact that slides throughout keeps the impulse ratio of Coulomb")
{
    // e_t = 1 - mu (1 + e) / tan(angle to the wall's normal), spin = -5/2 mu (1 + e) v_n / R (Chung and Ooi 2011, test 4)
    const double radius = 2.5e-3, speed = 3.9, friction = 0.092, e = 0.98;
    const auto parameters = test::material(1e7, e, friction);
    const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) * 4000;
    const double step = physics::contact_time(parameters.walls[0], mass) / 2000;
    for (const double degrees : {35.0, 50.0, 70.0, 85.0}) {
        const double angle = degrees * std::numbers::pi / 180, vn = speed * std::cos(angle), vt = speed * std::sin(angle);
        physics::ParticleDynamics dynamics({}, parameters, floor_wall, step);
        auto ball = test::sphere(0, Vec3(0, 0, radius + vn * step), radius, 4000);
        ball.velocity = Vec3(vt, 0, -vn);
        dynamics.particles.add(ball);
        test::run(dynamics, Vec3::Zero(), 2100);
        const auto& p = dynamics.particles;
        // gates: the first-order error of e, 2e-4 here, and the lever arm, shorter by the overlap (1 % of the radius)
        CHECK(p.velocity[2][0] == test::relative(e * vn).epsilon(1e-3));
        CHECK(std::abs(p.velocity[0][0] / vt - (1 - friction * (1 + e) / std::tan(angle))) < 5e-4);
        CHECK(p.spin[1][0] == test::relative(2.5 * friction * (1 + e) * vn / radius).epsilon(2e-2));
    }
}

TEST_CASE("two equal balls with opposite spins meet head-on without friction at the contact")
{
    // the surfaces do not move against each other (Chung and Ooi 2011, test 7): no tangential speed, the spins stay
    physics::ParticleDynamics dynamics({}, test::material(1e6, 0.5, 0.4), {}, 1e-7);
    for (int k = 0; k < 2; ++k) {
        auto ball = test::sphere(k, Vec3(k * 2.0001e-3, 0, 0), 1e-3);
        ball.velocity = Vec3(k == 0 ? 0.2 : -0.2, 0, 0);
        ball.spin = Vec3(0, 0, k == 0 ? 300 : -300);
        dynamics.particles.add(ball);
    }
    test::run(dynamics, Vec3::Zero(), 5000);
    const auto state = test::state(dynamics.particles);
    CHECK(state.at(0)[3] < -0.05);           // rebounded
    CHECK(std::abs(state.at(0)[4]) < 1e-12); // rounding
    CHECK(state.at(0)[8] == test::relative(300).epsilon(1e-12));
}

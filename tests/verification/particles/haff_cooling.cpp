// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=600 long
// A gas of inelastic spheres cools by itself.
#include "tests/support/particle_scene.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

constexpr int across = 16, count = across * across * across;
constexpr double diameter = 1e-3, fraction = 0.05, restitution = 0.9;

/// Kinetic energy per mass and degree of freedom [m2/s2].
double temperature(const core::ParticleSet& p)
{
    double sum = 0.0;
    for (int i = 0; i < p.owned; ++i) sum += p.velocity_of(i).squaredNorm();
    return sum / (3.0 * p.owned);
}

/// Velocities that are normally distributed, without a mean.
std::vector<Vec3> velocities()
{
    std::vector<Vec3> all;
    Vec3 mean = Vec3::Zero();
    for (int k = 0; k < count; ++k) {
        Vec3 v = Vec3::Zero();
        for (int a = 0; a < 3; ++a) {
            const auto u = core::random_uniform(3, k, std::uint64_t(a));
            v[a] = std::sqrt(-2.0 * std::log(1.0 - u[0])) * std::cos(2.0 * std::numbers::pi * u[1]);
        }
        all.push_back(v);
        mean += v / count;
    }
    for (Vec3& v : all) v -= mean;
    return all;
}

} // namespace

TEST_CASE("a gas of inelastic spheres cools by Haff's law before it clusters")
{
    const double spacing = diameter * std::cbrt(std::numbers::pi / 6 / fraction);
    core::Domain box;
    box.size = Vec3::Constant(across * spacing);
    box.periodic = {true, true, true};
    // contacts last a two-hundredth of the time that a sphere needs for its diameter: binary, to half a per cent
    const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(diameter / 2, 3) * 2500, time = 5e-3 * diameter;
    const auto parameters = test::material(physics::stiffness_of(time, mass / 2, restitution), restitution, 0.0);
    physics::ParticleDynamics dynamics(box, parameters, {}, time / 25);
    const auto start = velocities();
    for (int k = 0; k < count; ++k) {
        const Vec3 cell(k % across, k / across % across, k / (across * across));
        auto ball = test::sphere(k, spacing * (cell + Vec3::Constant(0.5)), diameter / 2);
        ball.velocity = start[std::size_t(k)];
        dynamics.particles.add(ball);
    }
    const auto run_for = [&](double seconds) { test::run(dynamics, Vec3::Zero(), int(std::lround(seconds / dynamics.step()))); };
    run_for(3 * diameter); // the lattice is forgotten after some collisions
    // Enskog: 1/t_H = 2/3 sqrt(pi) n d^2 g (1 - e^2) sqrt(T), g = (1 - C/2) / (1 - C)^3 (Carnahan and Starling)
    const double number = fraction / (std::numbers::pi / 6 * std::pow(diameter, 3));
    const double g = (1 - fraction / 2) / std::pow(1 - fraction, 3), before = temperature(dynamics.particles);
    const double rate =
        2.0 / 3.0 * std::sqrt(std::numbers::pi) * number * diameter * diameter * g * (1 - restitution * restitution) * std::sqrt(before);
    for (const double share : {0.5, 1.0}) {
        run_for(0.5 / rate);
        const double haff = before / std::pow(1 + share, 2);
        // 40,000 collisions scatter by half a per cent; contacts that last another half
        CHECK(std::abs(temperature(dynamics.particles) / haff - 1) < 0.02);
    }
}

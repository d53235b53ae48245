// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What contacts must not make: momentum and angular momentum, with any law.
#include "tests/support/impact.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

/// Linear springs, Hertz' springs, and those with cohesion and resistance against turning.
std::vector<physics::ContactParameters> laws()
{
    const test::Solid rubber{5e7, 0.4, 1000};
    std::vector<physics::ContactParameters> all{{1e4, 2.0 / 7.0, 0.7, 0.5}, test::hertz(rubber, rubber, 0.7, 0.5)};
    for (const auto rolling : {physics::RollingModel::constant, physics::RollingModel::spring}) {
        all.push_back(all[1]);
        all.back().rolling = rolling;
        all.back().rolling_friction = 0.2;
        all.back().twisting_friction = 0.1;
        all.back().cohesion = 0.05;
    }
    return all;
}

} // namespace

TEST_CASE("1600 frictional balls in a periodic box keep their momentum to round-off")
{
    for (const auto& law : laws()) {
        physics::ParticleParameters parameters;
        parameters.pairs = {law};
        core::Domain box;
        box.size = Vec3::Constant(12 * 3.2e-3);
        box.periodic = {true, true, true};
        physics::ParticleDynamics dynamics(box, parameters, {}, 2e-6);
        for (const auto& ball : test::loose_lattice(1600, 12, 12, Vec3::Zero(), 1.0)) dynamics.particles.add(ball);
        const auto& p = dynamics.particles;
        const auto momentum = [&] {
            Vec3 sum = Vec3::Zero();
            for (int i = 0; i < p.owned; ++i) sum += p.mass[std::size_t(i)] * p.velocity_of(i);
            return sum;
        };
        double scale = 0.0;
        for (int i = 0; i < p.owned; ++i) scale += p.mass[std::size_t(i)] * p.velocity_of(i).norm();
        const Vec3 before = momentum();
        test::run(dynamics, Vec3::Zero(), 3000);
        double moved = 0.0; // the balls did meet
        for (int i = 0; i < p.owned; ++i) moved += p.mass[std::size_t(i)] * p.velocity_of(i).norm();
        CHECK(moved < 0.97 * scale);
        CHECK((momentum() - before).norm() < 1e-13 * scale);
    }
}

TEST_CASE("two unequal balls that graze each other keep their angular momentum to round-off")
{
    for (const auto& law : laws()) {
        physics::ParticleParameters parameters;
        parameters.pairs = {law};
        physics::ParticleDynamics dynamics({}, parameters, {}, 1e-6);
        auto large = test::sphere(0, Vec3::Zero(), 2e-3), small = test::sphere(1, Vec3(2.9e-3, 5e-4, 3e-4), 1e-3);
        small.velocity = Vec3(-0.5, 0.7, -0.2);
        small.spin = Vec3(100, -300, 200);
        large.spin = Vec3(50, 20, -80);
        dynamics.particles.add(large);
        dynamics.particles.add(small);
        const auto& p = dynamics.particles;
        double scale = 0.0;
        const auto angular = [&] {
            Vec3 sum = Vec3::Zero();
            scale = 0.0;
            for (int i = 0; i < 2; ++i) {
                const Vec3 orbit = p.mass[std::size_t(i)] * p.position_of(i).cross(p.velocity_of(i));
                const Vec3 own = p.inertia[std::size_t(i)] * p.spin_of(i);
                sum += orbit + own;
                scale += orbit.norm() + own.norm();
            }
            return sum;
        };
        const Vec3 before = angular(), spin = small.spin;
        test::run(dynamics, Vec3::Zero(), 4000);
        CHECK((p.spin_of(test::place(p, 1)) - spin).norm() > 10.0); // friction did act
        CHECK((angular() - before).norm() < 1e-12 * scale);         // 1,000 steps of rounding
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// More than a thousand contacts of one ball: none is forgotten, whatever lists and histories do (NUMERICS D 49).
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

constexpr int count = 1200;
constexpr double large = 25e-3, small = 0.5e-3, overlap = 1e-6;

/// Grains pressed on a ball all around it, as evenly as sunflower seeds, each pushed along the ball at first.
physics::ParticleDynamics coated(double skin, int steps)
{
    physics::ParticleParameters parameters = test::material(1000, 0.9, 0.5);
    parameters.skin = skin;
    physics::ParticleDynamics dynamics({}, parameters, {}, 2e-6);
    dynamics.particles.add(test::sphere(0, Vec3::Zero(), large));
    dynamics.watch_contacts();
    for (int n = 0; n < count; ++n) {
        const double z = 1 - (2 * n + 1.0) / count, angle = n * std::numbers::pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
        const Vec3 out(r * std::cos(angle), r * std::sin(angle), z);
        auto grain = test::sphere(n + 1, (large + small - overlap) * out, small);
        grain.velocity = 0.01 * Vec3(-std::sin(angle), std::cos(angle), 0);
        dynamics.particles.add(grain);
    }
    for (int n = 0; n < steps; n += 10) {
        test::run(dynamics, Vec3::Zero(), 10);
        dynamics.measure_watched(core::SerialTeam{});
        dynamics.dissolve();
    }
    return dynamics;
}

} // namespace

TEST_CASE("a ball with 1200 grains on it counts them all, and every one of them feels friction")
{
    const physics::ParticleDynamics dynamics = coated(0.0, 10);
    const auto& p = dynamics.particles;
    const auto& counts = p.columns[std::size_t(dynamics.contact_columns()->coordination)];
    for (int i = 0; i < p.owned; ++i) {
        const bool ball = p.id[std::size_t(i)] == 0;
        CHECK(counts[std::size_t(i)] == (ball ? count : 1));
        if (!ball) CHECK(p.spin_of(i).norm() > 1e-3);
    }
    CHECK(dynamics.history.other.size() == 2 * count); // both sides keep each spring
}

TEST_CASE("how often lists and histories of 1200 contacts are made anew changes no bit")
{
    const auto usual = test::state(coated(0.0, 100).particles);
    CHECK(test::state(coated(20e-6, 100).particles) == usual);
    // all friction is between the grains and the ball: it takes the angular momentum of the grains, and some is left
    CHECK(usual.at(0)[8] > 0.0);
}

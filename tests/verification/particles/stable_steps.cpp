// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Steps up to the limit that the solver names keep a dense packing calm, for any damping and any law (NUMERICS D 39).
#include "tests/support/impact.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

constexpr double radius = 1e-3;

/// Greatest kinetic energy in the second half of a run over that of the start, of a periodic crystal with 12 contacts of each ball.
double growth(const physics::ContactParameters& contact, double squeeze, double share)
{
    const double mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * 2500, cube = 2 * std::sqrt(2.0) * radius * (1 - squeeze);
    const double step = share * physics::stable_step(contact, {mass / 2, radius / 2}, mass, 12);
    physics::ParticleParameters parameters;
    parameters.pairs = {contact};
    core::Domain box;
    box.size = Vec3::Constant(4 * cube);
    box.periodic = {true, true, true};
    physics::ParticleDynamics dynamics(box, parameters, {}, step);
    std::int64_t id = 0;
    for (int c = 0; c < 64; ++c)
        for (const Vec3& at : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0.5), Vec3(0, 0.5, 0.5)}) {
            auto ball = test::sphere(id++, cube * (Vec3(c % 4, c / 4 % 4, c / 16) + at + Vec3::Constant(0.25)), radius);
            const auto u = core::random_uniform(11, ball.id, 0), w = core::random_uniform(11, ball.id, 1);
            ball.velocity = 1e-4 * Vec3(u[0] - 0.5, u[1] - 0.5, w[0] - 0.5); // too slow to open a contact
            dynamics.particles.add(ball);
        }
    const auto energy = [&] {
        double sum = 0.0;
        for (int i = 0; i < dynamics.particles.owned; ++i)
            sum += dynamics.particles.velocity_of(i).squaredNorm() + 0.4 * radius * radius * dynamics.particles.spin_of(i).squaredNorm();
        return sum;
    };
    const double before = energy();
    double greatest = 0.0;
    for (int n = 0; n < 40; ++n) {
        test::run(dynamics, Vec3::Zero(), 50);
        if (n >= 20) greatest = std::max(greatest, energy());
    }
    return greatest / before;
}

} // namespace

TEST_CASE("a crystal gains no energy with steps up to the stable one")
{
    const test::Solid rubber{1e7, 0.4, 2500};
    for (const bool hertz : {false, true})
        for (const double e : {1.0, 0.5, 0.05}) {
            auto contact = hertz ? test::hertz(rubber, rubber, e, 10.0) : physics::ContactParameters{1000, 2.0 / 7.0, e, 10.0};
            contact.impact_speed = 1.0;
            const double squeeze = 0.5 * (hertz ? physics::greatest_overlap(contact, {5.2e-6, radius / 2}) / (2 * radius) : 0.01);
            for (const double share : {0.5, 0.9, 0.99}) {
                CAPTURE(hertz);
                CAPTURE(e);
                CAPTURE(share);
                // near the limit, velocities at the ends of steps are greater than those in between
                CHECK(growth(contact, squeeze, share) < (e < 1 ? 1.0 : 4.0));
            }
        }
}

TEST_CASE("a sub-step in which a ball moves by more than 0.15 of the smallest radius is refused, with the longest that would do")
{
    const double step = 1e-5;
    const auto run = [&](double share) {
        physics::ParticleDynamics dynamics({}, test::material(1000, 0.5, 0.5), {}, step);
        auto fast = test::sphere(0, Vec3::Zero(), 3 * radius);
        fast.velocity = Vec3(0, 0, share * radius / step);
        dynamics.particles.add(fast);
        dynamics.particles.add(test::sphere(1, Vec3(10 * radius, 0, 0), radius));
        test::run(dynamics, Vec3::Zero(), 3);
    };
    CHECK_NOTHROW(run(0.149));
    const double longest = 0.15 / 0.151 * step;
    CHECK_THROWS_WITH_AS(run(0.151), doctest::Contains(core::text("longer than ", longest, " s").c_str()), core::NumericsError);
}

TEST_CASE("a frictional heap that springs against rolling hold does not creep in a hundred thousand steps")
{
    // balls without rolling friction go on to roll and to spin in their places
    physics::ContactParameters contact{1000, 2.0 / 7.0, 0.2, 0.5};
    contact.rolling_friction = contact.twisting_friction = 0.1;
    physics::ParticleParameters parameters;
    parameters.pairs = parameters.walls = {contact};
    core::Domain box;
    box.size = Vec3(12.8e-3, 12.8e-3, 1.0);
    box.periodic = {true, true, false};
    physics::ParticleDynamics dynamics(box, parameters, {physics::PlaneWall{}}, 1e-5);
    for (const auto& ball : test::loose_lattice(64, 4, 4, Vec3::Zero(), 0.1)) dynamics.particles.add(ball);
    test::run(dynamics, Vec3(0, 0, -9.81), 50000);
    const auto before = test::state(dynamics.particles);
    test::run(dynamics, Vec3(0, 0, -9.81), 100000);
    double farthest = 0.0;
    for (const auto& [id, row] : test::state(dynamics.particles))
        for (std::size_t a = 0; a < 3; ++a) farthest = std::max(farthest, std::abs(row[a] - before.at(id)[a]));
    CHECK(farthest < 1e-12 * radius);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Invariants of many particles: momentum, and results that do not depend on threads or lists.
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

const physics::ParticleParameters rough = test::material(1000, 0.6, 0.5);

Vec3 momentum(const core::ParticleSet& p)
{
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < p.owned; ++i) sum += p.mass[std::size_t(i)] * p.velocity_of(i);
    return sum;
}

physics::ParticleDynamics falling_lattice(const core::Domain& domain, double skin, double near_skin)
{
    auto parameters = rough;
    parameters.skin = skin;
    parameters.near_skin = near_skin;
    physics::ParticleDynamics dynamics(domain, parameters, {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()}}, 1e-5);
    for (const auto& s : test::loose_lattice(1600, 12, 12, Vec3::Zero(), 1.0)) dynamics.particles.add(s);
    return dynamics;
}

const core::Domain periodic_box{Vec3::Zero(), Vec3(12 * 3.2e-3, 12 * 3.2e-3, 0.1), {true, true, false}};
const core::Domain open_box{Vec3::Zero(), Vec3(12 * 3.2e-3, 12 * 3.2e-3, 0.1), {false, false, false}};

} // namespace

TEST_CASE("1600 rough balls in a periodic box keep their momentum")
{
    const core::Domain box{Vec3::Zero(), Vec3::Constant(12 * 3.2e-3), {true, true, true}};
    physics::ParticleDynamics dynamics(box, rough, {}, 1e-5);
    double scale = 0.0;
    for (const auto& s : test::loose_lattice(1600, 12, 12, Vec3::Zero(), 1.0)) dynamics.particles.add(s);
    for (int i = 0; i < 1600; ++i) scale += dynamics.particles.mass[std::size_t(i)] * dynamics.particles.velocity_of(i).norm();
    const Vec3 before = momentum(dynamics.particles);
    test::run(dynamics, Vec3::Zero(), 2000);
    CHECK((momentum(dynamics.particles) - before).norm() < 1e-13 * scale);
}

TEST_CASE("an oblique impact of unequal balls keeps momentum and angular momentum")
{
    physics::ParticleDynamics dynamics({}, rough, {}, 1e-6);
    auto a = test::sphere(3, Vec3(0, 0, 0), 1e-3, 1000), b = test::sphere(1, Vec3(4e-3, 1.5e-3, 0.5e-3), 2.5e-3, 3000);
    a.velocity = Vec3(1, 0, 0.3);
    a.spin = Vec3(100, 200, -400);
    b.spin = Vec3(-50, 10, 300);
    dynamics.particles.add(a);
    dynamics.particles.add(b);
    const auto angular = [&] {
        const auto& p = dynamics.particles;
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < 2; ++i)
            sum += p.mass[std::size_t(i)] * p.position_of(i).cross(p.velocity_of(i)) + p.inertia[std::size_t(i)] * p.spin_of(i);
        return sum;
    };
    const Vec3 linear_before = momentum(dynamics.particles), before = angular();
    const Vec3 velocity = dynamics.particles.velocity_of(0);
    test::run(dynamics, Vec3::Zero(), 2000);
    CHECK((dynamics.particles.velocity_of(0) - velocity).norm() > 0.1); // they did meet
    CHECK((momentum(dynamics.particles) - linear_before).norm() < 1e-13 * linear_before.norm());
    CHECK((angular() - before).norm() < 1e-13 * before.norm()); // rounding of 2000 steps
}

TEST_CASE("any number of threads gives the same bits")
{
    auto one = falling_lattice(periodic_box, 0, 0);
    test::run(one, Vec3(0, 0, -9.81), 3000);
    for (const int threads : {2, 3}) {
        auto more = falling_lattice(periodic_box, 0, 0);
        test::run(more, Vec3(0, 0, -9.81), 3000, *core::make_openmp_team(threads));
        CHECK(test::state(more.particles) == test::state(one.particles));
    }
}

TEST_CASE("the reach of the lists does not change a bit")
{
    auto usual = falling_lattice(open_box, 0, 0);
    test::run(usual, Vec3(0, 0, -9.81), 3000);
    for (const auto& [skin, near] : {std::pair{0.1e-3, 0.02e-3}, {2e-3, 1e-3}}) {
        auto other = falling_lattice(open_box, skin, near);
        test::run(other, Vec3(0, 0, -9.81), 3000);
        CHECK(test::state(other.particles) == test::state(usual.particles));
    }
}

TEST_CASE("batches of sub-steps may be cut anywhere")
{
    auto whole = falling_lattice(open_box, 0, 0), cut = falling_lattice(open_box, 0, 0);
    test::run(whole, Vec3(0, 0, -9.81), 1000);
    for (const int part : {1, 300, 699}) test::run(cut, Vec3(0, 0, -9.81), part);
    CHECK(test::state(cut.particles) == test::state(whole.particles));
}

TEST_CASE("no particle and one particle are fine")
{
    physics::ParticleDynamics none(periodic_box, rough, {physics::PlaneWall{}}, 1e-5),
        one(periodic_box, rough, {physics::PlaneWall{}}, 1e-5);
    test::run(none, Vec3(0, 0, -9.81), 10);
    CHECK(none.particles.size() == 0);
    one.particles.add(test::sphere(0, Vec3(1e-3, 1e-3, 0.05), 1e-3));
    test::run(one, Vec3(0, 0, -9.81), 1000);
    CHECK(one.particles.velocity[2][0] == test::relative(-9.81e-2).epsilon(1e-12));
}

TEST_CASE("particles at the same place part, each way the same in every run")
{
    const auto part = [&] {
        physics::ParticleDynamics dynamics(open_box, test::material(10, 0.2, 0.5), {}, 1e-5);
        dynamics.particles.add(test::sphere(0, Vec3::Constant(0.01), 1e-3));
        dynamics.particles.add(test::sphere(1, Vec3::Constant(0.01), 1e-3));
        test::run(dynamics, Vec3::Zero(), 5000);
        return test::state(dynamics.particles);
    };
    const auto state = part();
    const Vec3 apart(state.at(1)[0] - state.at(0)[0], state.at(1)[1] - state.at(0)[1], state.at(1)[2] - state.at(0)[2]);
    CHECK(apart.norm() > 1.99e-3); // no longer overlapping
    CHECK(part() == state);
}

TEST_CASE("a domain a million metres away loses nothing")
{
    auto near = falling_lattice(open_box, 0, 0), far = falling_lattice({Vec3::Constant(1e6), open_box.size, {}}, 0, 0);
    test::run(near, Vec3(0, 0, -9.81), 500);
    test::run(far, Vec3(0, 0, -9.81), 500);
    CHECK(test::state(near.particles) == test::state(far.particles));
}

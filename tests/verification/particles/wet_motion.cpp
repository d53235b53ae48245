// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Drag, loads and contact impulses of particles in a frozen fluid; materials by species.
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using test::Vec3;

TEST_CASE("drag and a constant load act exactly, however long the step")
{
    for (const double step : {1e-5, 1e-2}) {
        physics::ParticleDynamics dynamics({}, test::material(1000, 0.6, 0.5), {}, step);
        dynamics.particles.add(test::sphere(0, Vec3::Zero(), 1e-3));
        auto& p = dynamics.particles;
        const auto columns = physics::add_wet_columns(p);
        physics::WetLoad load;
        load.force = Vec3(0, 0, -2e-5);
        load.fluid_velocity = Vec3(0.3, 0, 0);
        load.drag = 3e-4;
        load.added_mass = 0.5e-5;
        load.fluid_spin = Vec3(0, 5, 0);
        load.spin_drag = 1e-9;
        physics::set_wet_load(p, columns, 0, load, step);
        const int steps = int(std::lround(0.1 / step));
        physics::settle(dynamics, physics::WetMotion{columns}, steps, core::SerialTeam{});
        const double kept = std::exp(-0.1 * load.drag / (p.mass[0] + load.added_mass));
        const double spin_kept = std::exp(-0.1 * load.spin_drag / p.inertia[0]);
        // rounding of up to 10,000 steps
        CHECK(p.velocity[0][0] == test::relative(0.3 * (1 - kept)).epsilon(1e-11));
        CHECK(p.velocity[2][0] == test::relative(-2e-5 / 3e-4 * (1 - kept)).epsilon(1e-11));
        CHECK(p.spin[1][0] == test::relative(5 * (1 - spin_kept)).epsilon(1e-11));
    }
}

TEST_CASE("without drag a wet particle moves as a dry one")
{
    const double step = 1e-5, g = 9.81;
    const std::vector<physics::Wall> floor_wall{physics::PlaneWall{}};
    physics::ParticleDynamics dry({}, test::material(1000, 0.6, 0.5), floor_wall, step), wet = dry;
    for (auto* d : {&dry, &wet}) d->particles.add(test::sphere(0, Vec3(0, 0, 1.5e-3), 1e-3));
    const auto columns = physics::add_wet_columns(wet.particles);
    const double weight = wet.particles.mass[0] * g;
    physics::set_wet_load(wet.particles, columns, 0, {.force = Vec3(0, 0, -weight)}, step);
    test::run(dry, Vec3(0, 0, -g), 20000);
    physics::settle(wet, physics::WetMotion{columns}, 20000, core::SerialTeam{});
    CHECK(wet.particles.position[2][0] == test::relative(dry.particles.position[2][0]).epsilon(1e-9)); // rounding through bounces
    // at rest after 0.2 s: contacts have given back all that gravity gave
    CHECK(wet.particles.columns[std::size_t(columns.impulse + 2)][0] == test::relative(weight * 0.2).epsilon(1e-6));
}

TEST_CASE("contact impulses of a closed box of particles sum to zero")
{
    const core::Domain box{Vec3::Zero(), Vec3::Constant(6 * 3.2e-3), {true, true, true}};
    physics::ParticleDynamics dynamics(box, test::material(1000, 0.6, 0.5), {}, 1e-5);
    for (const auto& s : test::loose_lattice(216, 6, 6, Vec3::Zero(), 1.0)) dynamics.particles.add(s);
    const auto columns = physics::add_wet_columns(dynamics.particles);
    for (int i = 0; i < 216; ++i) physics::set_wet_load(dynamics.particles, columns, i, {.drag = 1e-4}, 1e-5);
    physics::settle(dynamics, physics::WetMotion{columns}, 500, core::SerialTeam{});
    double sum = 0.0, size = 0.0;
    for (const double impulse : dynamics.particles.columns[std::size_t(columns.impulse)]) {
        sum += impulse;
        size += std::abs(impulse);
    }
    CHECK(size > 0.0);
    CHECK(std::abs(sum) < 1e-13 * size);
}

TEST_CASE("equal materials of two species give the bits of one")
{
    const auto run = [](bool table) {
        auto parameters = test::material(1000, 0.6, 0.5);
        parameters.species = 2;
        if (table) parameters.pairs.resize(4, parameters.pairs[0]), parameters.walls.resize(2, parameters.walls[0]);
        physics::ParticleDynamics dynamics({}, parameters, {physics::PlaneWall{}}, 1e-5);
        for (auto s : test::loose_lattice(300, 5, 5, Vec3::Zero(), 1.0)) {
            s.species = int(s.id % 2);
            dynamics.particles.add(s);
        }
        test::run(dynamics, Vec3(0, 0, -9.81), 2000);
        return test::state(dynamics.particles);
    };
    CHECK(run(true) == run(false));
}

TEST_CASE("species with other materials meet by their own laws")
{
    // two impacts head-on along x, far apart: species 0 with 0 at e = 0.9, species 0 with 1 at e = 0.3
    auto parameters = test::material(1000, 0.9, 0.5);
    parameters.species = 2;
    parameters.pairs.resize(4, parameters.pairs[0]);
    parameters.pairs[1].restitution = parameters.pairs[2].restitution = 0.3;
    physics::ParticleDynamics dynamics({}, parameters, {}, 1e-7);
    for (int k = 0; k < 4; ++k) {
        auto s = test::sphere(k, Vec3(k % 2 * 2.001e-3, k / 2 * 0.1, 0), 1e-3);
        s.velocity = Vec3(k % 2 == 0 ? 0.5 : -0.5, 0, 0);
        s.species = k == 3 ? 1 : 0;
        dynamics.particles.add(s);
    }
    test::run(dynamics, Vec3::Zero(), 5000);
    const auto state = test::state(dynamics.particles);
    CHECK(state.at(1)[3] == test::relative(0.5 * 0.9).epsilon(2e-3)); // first order in the step
    CHECK(state.at(3)[3] == test::relative(0.5 * 0.3).epsilon(2e-3));
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Walls of several materials in one scene: each gives its own restitution and friction.
// ctest: timeout=60
#include "core/comm/communicator.hpp"
#include "io/run/world.hpp"
#include "tests/support/particle_scene.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

/// Weightless glass between a floor of rubber, a table of steel and other walls.
io::Scene room(const std::string& walls)
{
    return test::scene_from_text(
        "name: room\ngrid: { box: { size: [30 mm, 30 mm, 10 mm], cells: [6, 6, 2], blocks: [2, 1, 1] } }\nparticles:\n"
        "  - { name: S, material: glass, count: 3, diameter: 2 mm, density: 2500 kg/m3 }\n"
        "contact:\n  stiffness: 1 kN/m\n  restitution: 0.6\n  friction: 0\n  steps_per_contact: 2000\n  walls: " +
        walls +
        "\n  sides: [{ at: y_low, material: rubber }]\n"
        "  pairs: [{ between: [glass, rubber], restitution: 0.3 }, { between: [steel, glass], restitution: 0.9 }]\n"
        "walls:\n  - { name: table, material: steel, disc: { point: [22 mm, 10 mm, 5 mm], normal: y, radius: 4 mm } }\n"
        "run: { until: 1 s, time_step: 1 ms }\n");
}

} // namespace

TEST_CASE("spheres rebound from each wall with the restitution of its material")
{
    for (const std::string walls : {"faces", "primitive"}) {
        CAPTURE(walls);
        io::World world(room(walls), core::Communicator::self());
        core::ParticleSet& p = world.grains()->particles;
        const std::array<Vec3, 3> places{Vec3(6e-3, 3e-3, 5e-3), Vec3(22e-3, 13e-3, 5e-3), Vec3(27e-3, 22e-3, 5e-3)};
        const std::array<Vec3, 3> speeds{-Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitX()};
        for (int n = 0; n < 3; ++n)
            for (int a = 0; a < 3; ++a) {
                const auto i = std::size_t(test::place(p, n));
                p.position[std::size_t(a)][i] = places[std::size_t(n)][a];
                p.velocity[std::size_t(a)][i] = speeds[std::size_t(n)][a];
            }
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        for (int step = 0; step < 4; ++step) world.step(*executor); // 2 ms to the wall
        const auto state = test::state(p);
        const double expected[] = {0.3, 0.9, 0.6};
        // damped contacts are of first order: 2.6e-3 at 200 steps and e = 0.5 (NUMERICS A13), a tenth of it at 2000
        for (int n = 0; n < 3; ++n) CHECK(std::abs(state.at(n)[n == 2 ? 3 : 4]) == test::relative(expected[n]).epsilon(3e-3));
    }
}

TEST_CASE("a ball that slides from one material to another on a flat wall is slowed by the friction of each")
{
    const double radius = 1e-3, g = 9.81, friction[] = {0.1, 0.3}, seam = 5e-3;
    const std::vector<Vec3> vertices{{0, -5e-3, 0}, {seam, -5e-3, 0}, {seam, 5e-3, 0}, {0, 5e-3, 0}, {0.02, -5e-3, 0}, {0.02, 5e-3, 0}};
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}, {1, 4, 5, 2}};
    physics::ParticleParameters parameters = test::material(1000, 0.5, 0);
    parameters.wall_materials = 2;
    parameters.walls = {parameters.walls[0], parameters.walls[0]};
    for (std::size_t n = 0; n < 2; ++n) parameters.walls[n].friction = friction[n];
    const auto ball = [&] {
        auto s = test::sphere(0, Vec3(2e-3, 0, radius), radius);
        s.velocity = Vec3(0.5, 0, 0);
        return s;
    }();
    const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) * 2500, step = 2e-6;
    physics::ParticleDynamics dynamics({}, parameters, {}, step);
    dynamics.add_surface({vertices, quads, 0.27, std::array{0, 1}});
    auto resting = ball;
    resting.position.z() -= mass * g / 1000;
    dynamics.particles.add(resting);
    for (int n = 0; n < 100 && dynamics.particles.position[0][0] < 12e-3; ++n) test::run(dynamics, Vec3(0, 0, -g), 1000);
    const double x = dynamics.particles.position[0][0], v = dynamics.particles.velocity[0][0];
    // all the way it slides: v^2 falls by 2 mu g of each stretch; the surface is left only when rolling, at 5/7 of the speed
    const double expected = std::sqrt(0.25 - 2 * g * (friction[0] * (seam - 2e-3) + friction[1] * (x - seam)));
    REQUIRE(v > 5.0 / 7 * 0.5);
    CHECK(v == test::relative(expected).epsilon(3e-4)); // faces overlap by a thousandth of their size, 15 um of one friction for the other
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Balls on walls of faces: pipes, corners, edges and joints against exact statics and motion (NUMERICS D 44, 45).
#include "core/base/error.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/rolling_ball.hpp"
#include "tests/support/wall_faces.hpp"
#include <doctest/doctest.h>

using test::Faces;
using test::Vec3;

namespace {

/// Strips of width `size` along x, joined at z heights: corner k of the profile is (y, z).
Faces channel(const std::vector<std::pair<double, double>>& profile, double size)
{
    Faces f;
    for (const auto& [y, z] : profile)
        for (int i = 0; i <= 4; ++i) f.vertices.push_back(Vec3(size * i, y, z));
    for (int k = 0; k + 1 < int(profile.size()); ++k)
        for (int i = 0; i < 4; ++i) f.quads.push_back({5 * k + i, 5 * k + i + 1, 5 * k + i + 6, 5 * k + i + 5});
    return f;
}

double rolling_energy_error(const Faces& faces, double smooth_angle, double drift)
{
    const test::RollingBall ball{.drift = drift};
    return ball.roll({}, physics::WallSurface(faces.vertices, faces.quads, smooth_angle)).energy_error;
}

/// Force on a ball at rest that is pressed into a surface, from one tiny step [N].
Vec3 static_force(const Faces& faces, const Vec3& centre, double radius)
{
    const double step = 1e-9;
    physics::ParticleDynamics dynamics({}, test::material(1000, 1.0, 0.5), {}, step);
    dynamics.add_surface(physics::WallSurface(faces.vertices, faces.quads));
    dynamics.particles.add(test::sphere(0, centre, radius));
    test::run(dynamics, Vec3::Zero(), 1);
    return dynamics.particles.mass[0] / step * dynamics.particles.velocity_of(0);
}

/// Balls thrown about in a pipe of faces between two planes.
std::map<std::int64_t, std::array<double, 9>> thrown_balls(double skin, double near_skin)
{
    const Faces faces = test::pipe(10e-3, 40e-3, 32, 12);
    auto parameters = test::material(1000, 0.6, 0.5);
    parameters.skin = skin;
    parameters.near_skin = near_skin;
    const std::vector<physics::Wall> ends{physics::PlaneWall{Vec3(0.5e-3, 0, 0), Vec3::UnitX()},
                                          physics::PlaneWall{Vec3(39e-3, 0, 0), -Vec3::UnitX()}};
    physics::ParticleDynamics dynamics({}, parameters, ends, 1e-5);
    dynamics.add_surface(physics::WallSurface(faces.vertices, faces.quads));
    for (int n = 0; n < 60; ++n) {
        auto ball = test::sphere(n, Vec3(2.5e-3 + 3.5e-3 * (n % 10), -4e-3 + 4e-3 * (n / 10 % 3), -2e-3 + 4e-3 * (n / 30)),
                                 1e-3 + 0.5e-3 * (n % 2));
        ball.velocity = 0.5 * Vec3(n % 3 - 1, n % 5 - 2, n % 7 - 3);
        dynamics.particles.add(ball);
    }
    test::run(dynamics, Vec3(0, 0, -9.81), 4000);
    return test::state(dynamics.particles);
}

} // namespace

TEST_CASE("a ball rolling round inside a pipe of faces keeps its energy")
{
    for (const int around : {32, 64, 128})
        CHECK(rolling_energy_error(test::pipe(25e-3, 40e-3, around, 12), 0.27, 0.0) < 1e-5); // 3e-6 measured; 1e-6 for each joint is wanted
    CHECK(rolling_energy_error(test::pipe(25e-3, 40e-3, 64, 12), 0.27, 0.05) < 1e-5);
}

TEST_CASE("a plane of many faces is one plane, also at joints and corners")
{
    const Faces plane = channel({{0, 0}, {1e-3, 0}, {2e-3, 0}, {3e-3, 0}}, 1e-3);
    for (const Vec3& place :
         {Vec3(1.5e-3, 1.5e-3, 0.9e-3), Vec3(2e-3, 1.5e-3, 0.9e-3), Vec3(2e-3, 1e-3, 0.9e-3), Vec3(2.2e-3, 2e-3, 0.9e-3)})
        CHECK((static_force(plane, place, 1e-3) - Vec3(0, 0, 0.1)).norm() < 1e-8); // k_n times overlap; rounding of one tiny step
}

TEST_CASE("a concave edge presses from both sides, a convex one once")
{
    const double r = 1e-3, overlap = 1e-5;
    // right-angled groove: faces y = 0 and z = 0
    const Faces groove = channel({{0, 3e-3}, {0, 0}, {3e-3, 0}}, 1e-3);
    CHECK((static_force(groove, Vec3(2e-3, r - overlap, r - overlap), r) - 1000 * overlap * Vec3(0, 1, 1)).norm() < 1e-8);
    // away from the side wall the edge is only a shadow
    CHECK((static_force(groove, Vec3(2e-3, 1.2 * r, r - overlap), r) - 1000 * overlap * Vec3(0, 0, 1)).norm() < 1e-8);
    // ridge with its edge on the x axis
    const Faces ridge = channel({{-3e-3, -3e-3}, {0, 0}, {3e-3, -3e-3}}, 1e-3);
    CHECK((static_force(ridge, Vec3(2e-3, 0, r - overlap), r) - 1000 * overlap * Vec3(0, 0, 1)).norm() < 1e-8);
    CHECK((static_force(ridge, Vec3(1.7e-3, 0, r - overlap), r) - 1000 * overlap * Vec3(0, 0, 1)).norm() < 1e-8);
    const Vec3 aside = (r - overlap) * Vec3(0, 0.2, 1).normalized(); // still over the edge, not over a face
    CHECK((static_force(ridge, Vec3(1.7e-3, 0, 0) + aside, r) - 1000 * overlap * aside.normalized()).norm() < 1e-8);
}

TEST_CASE("friction goes on across the joints of faces")
{
    // a ball rolled up an inclined plane of small faces by a constant force without slip: a = g sin 5/7
    const Faces plane = channel({{0, 0}, {0.25e-3, 0}, {0.5e-3, 0}, {0.75e-3, 0}, {1e-3, 0}, {10e-3, 0}}, 10e-3);
    const double r = 1e-3, stiffness = 1e4, g = 9.81, mass = 4.0 / 3.0 * std::numbers::pi * 1e-9 * 2500;
    const auto parameters = test::material(stiffness, 0.5, 0.5);
    physics::ParticleDynamics dynamics({}, parameters, {}, physics::contact_time(parameters.walls[0], mass) / 50);
    dynamics.add_surface(physics::WallSurface(plane.vertices, plane.quads));
    dynamics.particles.add(test::sphere(0, Vec3(15e-3, 0.1e-3, r - mass * g / stiffness), r));
    const double time = 0.02, pull = 2.0;
    test::run(dynamics, Vec3(0, pull, -g), int(time / dynamics.step()));
    CHECK(dynamics.particles.velocity[1][0] == test::relative(5.0 / 7.0 * pull * time).epsilon(5e-3)); // the spring's first swing
}

TEST_CASE("how far lists reach changes no bit of what walls do")
{
    const auto usual = thrown_balls(0.0, 0.0);
    CHECK(thrown_balls(0.1e-3, 0.01e-3) == usual);
    CHECK(thrown_balls(2e-3, 1e-3) == usual);
}

TEST_CASE("faces that do not exist or have no area are refused")
{
    const std::vector<Vec3> vertices{Vec3::Zero(), Vec3::UnitX(), Vec3(1, 1, 0), Vec3::UnitY()};
    const std::vector<std::array<int, 4>> missing{{0, 1, 2, 7}}, thin{{0, 1, 1, 0}};
    CHECK_THROWS_AS(physics::WallSurface(vertices, missing), core::ConfigError);
    CHECK_THROWS_AS(physics::WallSurface(vertices, thin), core::ConfigError);
}

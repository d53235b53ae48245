// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Surfaces of a hundred thousand triangles: balls roll in them as in a round drum, and what is inside a closed one is found.
// ctest: timeout=120
#include "core/base/error.hpp"
#include "physics/particles/surface_side.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/rolling_ball.hpp"
#include "tests/support/triangles.hpp"
#include <doctest/doctest.h>

using physics::WallSide;
using test::Triangles, test::Vec3;

namespace {

/// How often a closed surface goes round a place: the solid angles of its triangles.
/// @source  Van Oosterom and Strackee (1983), The solid angle of a plane triangle.
double winding(const physics::TriangleMesh& mesh, const Vec3& x)
{
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.vertices[std::size_t(t[0])] - x, b = mesh.vertices[std::size_t(t[1])] - x,
                   c = mesh.vertices[std::size_t(t[2])] - x;
        const double below = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
        sum += 2 * std::atan2(a.dot(b.cross(c)), below);
    }
    return std::abs(sum) / (4 * std::numbers::pi);
}

} // namespace

TEST_CASE("a ball that rolls round in a drum of a hundred thousand triangles keeps its energy and its friction")
{
    const test::RollingBall ball{.drift = 0.03};
    const auto round = ball.roll({physics::CylinderWall{Vec3::Zero(), Vec3::UnitX(), ball.cylinder}});
    const auto fine = ball.roll({}, test::surface(test::drum(ball.cylinder, 40e-3, 400, 125)));
    // 400 edges around and 50 along the way: 1e-6 of the energy for each joint would be 4e-4
    CHECK(fine.energy_error < 1e-5);
    CHECK(fine.at == test::relative(round.at).epsilon(1e-5)); // lost friction would let the ball slip along the axis
}

TEST_CASE("a place is inside a closed surface where the solid angles of its triangles say so, also right below edges and corners")
{
    // a drum with a hole in its middle, a ring, and a ball of eight sides within the hole
    Triangles triangles;
    const auto ring_at = [](int i, int j) {
        const double a = std::numbers::pi * (i % 12) / 6, b = std::numbers::pi * (j % 9) / 4.5, r = 3 + std::cos(b);
        return Vec3(r * std::cos(a), r * std::sin(a), std::sin(b));
    };
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 9; ++j) test::add_quad(triangles, ring_at(i, j), ring_at(i + 1, j), ring_at(i + 1, j + 1), ring_at(i, j + 1));
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) { // seen from outside the corners go round in one sense
                const bool swapped = x * y * z < 0;
                triangles.push_back({Vec3(x, 0, 0), swapped ? Vec3(0, 0, z) : Vec3(0, y, 0), swapped ? Vec3(0, y, 0) : Vec3(0, 0, z)});
            }
    const auto mesh = physics::joined_triangles(triangles);
    const physics::SurfaceSide inside(mesh, WallSide::inside), outside(mesh, WallSide::outside);
    int found = 0;
    const auto compare = [&](const Vec3& x) {
        const double times = winding(mesh, x);
        if (std::abs(times - std::round(times)) > 1e-6) return; // on the surface
        const bool wanted = times > 0.5;
        found += wanted;
        CHECK(inside.holds(x) == wanted);
        CHECK(outside.holds(x) != wanted);
    };
    for (int n = 0; n < 1000; ++n) {
        const auto u = core::random_uniform(5, n, 0), w = core::random_uniform(5, n, 1);
        compare(Vec3(9 * u[0] - 4.5, 9 * u[1] - 4.5, 3 * w[0] - 1.5));
    }
    for (const auto& t : mesh.triangles) { // rays through corners and edges
        const Vec3 corner = mesh.vertices[std::size_t(t[0])], middle = 0.5 * (corner + mesh.vertices[std::size_t(t[1])]);
        for (const double z : {-0.37, 0.41, 0.53}) { // none on the flat faces within the hole
            compare(Vec3(corner.x(), corner.y(), z));
            compare(Vec3(middle.x(), middle.y(), z));
        }
    }
    CHECK(found > 300);
    triangles.pop_back();
    CHECK_THROWS_AS(physics::SurfaceSide(physics::joined_triangles(triangles), WallSide::inside), core::ConfigError);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Balls on the walls of blocks whose points do not match: where the walls go on in each other, nothing is felt.
#include "core/grid/pipe.hpp"
#include "core/grid/surface.hpp"
#include "core/grid/touching_blocks.hpp"
#include "tests/support/joined_boxes.hpp"
#include "tests/support/rolling_ball.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

physics::WallSurface walls_of(core::MultiBlock grid)
{
    grid.boundary_name = [](core::BlockId, core::Side) { return std::string("wall"); };
    const core::Mesh mesh(std::move(grid), 0, 1);
    const core::Surface surface = core::boundary_surface(mesh, std::vector<std::string>{"wall"}, 0.0);
    return {surface.vertices, surface.quads, 0.6};
}

/// Two pieces of a round pipe about x, 40 mm long and 50 mm wide, that meet half way.
core::MultiBlock two_pieces(int first, int second)
{
    core::MultiBlock grid;
    for (const int across : {first, second}) {
        core::Pipe p;
        p.diameter = 50e-3;
        p.length = 20e-3;
        p.core_cells = across / 2;
        p.wing_cells = across / 4;
        p.axial_cells = across / 2;
        p.blocks_along = 1;
        const double start = grid.blocks.empty() ? 0 : 20e-3;
        for (core::Vertices& block : core::make_pipe(p).blocks) {
            for (Vec3& x : block.data()) x.x() += start;
            grid.blocks.push_back(std::move(block));
        }
    }
    core::join_touching_blocks(grid);
    return grid;
}

} // namespace

TEST_CASE("a ball that rolls over a floor in two blocks keeps its energy, height and way")
{
    const core::Box first{{0, 0, 0}, {20e-3, 10e-3, 10e-3}, {11, 4, 5}, {1, 1, 1}, {}};
    const core::Box second{{20e-3, 0, 0}, {40e-3, 10e-3, 10e-3}, {7, 4, 8}, {1, 1, 1}, {}};
    const double radius = 1e-3, stiffness = 1e4, speed = 0.3, g = 9.81;
    const auto parameters = test::material(stiffness, 1.0, 0.5);
    auto ball = test::sphere(0, Vec3::Zero(), radius);
    const double mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * ball.density, press = mass * g / stiffness;
    for (const double z : {3e-3, 5e-3, 4.62e-3}) {
        physics::ParticleDynamics dynamics({}, parameters, {}, physics::contact_time(parameters.walls[0], mass) / 50);
        dynamics.add_surface(walls_of(test::joined({first, second}, {}, [](const Vec3& x) { return x; })));
        ball.position = Vec3(15e-3, radius - press, z);
        ball.velocity = Vec3(speed, 0, 0);
        ball.spin = Vec3(0, 0, -speed / (radius - press));
        dynamics.particles.add(ball);
        double highest = 0;
        for (int n = 0; n < 20; ++n) {
            test::run(dynamics, Vec3(0, -g, 0), int(1.5e-3 / dynamics.step()));
            highest = std::max(highest, std::abs(dynamics.particles.position[1][0] - ball.position.y()));
        }
        const auto& p = dynamics.particles;
        MESSAGE("at ", p.position_of(0).transpose(), ", height off by ", highest / press, " of the overlap");
        CHECK(p.position[0][0] > 23e-3);
        CHECK(std::abs(p.position[2][0] - z) < 1e-9 * radius); // rounding; a second contact at an edge would turn it aside
        CHECK(highest < 1e-6 * press);
        CHECK(std::abs(p.velocity_of(0).x() / speed - 1) < 1e-6);
    }
}

TEST_CASE("a ball that rolls round in a pipe over the seam of two sections keeps its energy")
{
    const test::RollingBall ball{.at = 19e-3, .drift = 0.05}; // its way along the axis sways by 1.5 mm: over the seam at 20 mm and back
    const auto alike = ball.roll({}, walls_of(two_pieces(24, 24))), joined = ball.roll({}, walls_of(two_pieces(24, 32)));
    MESSAGE("energy off by ", joined.energy_error, ", where the sections match ", alike.energy_error);
    CHECK(joined.energy_error < 1e-5); // as in wall_surfaces.cpp
    CHECK(std::abs(joined.at - alike.at) < 1e-6);
}

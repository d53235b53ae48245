// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/box.hpp"
#include "core/grid/pipe.hpp"
#include "core/grid/surface.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>
#include <map>

using core::Mesh, core::Vec3;

TEST_CASE("the surface of a closed box of blocks is closed, welded and looks inwards")
{
    const Mesh mesh(core::make_box({{0, 0, 0}, {1, 2, 3}, {4, 4, 4}, {2, 2, 1}}), 0, 1);
    const std::vector<std::string> names{"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
    const auto surface = core::boundary_surface(mesh, names, 0.0);
    CHECK(surface.quads.size() == 6 * 16);
    CHECK(surface.vertices.size() == 6 * 16 + 2); // Euler: V - E + F = 2 with E = 2 F
    std::map<std::pair<int, int>, int> edges;
    for (const auto& q : surface.quads) {
        const Vec3 a = surface.vertices[std::size_t(q[0])], c = surface.vertices[std::size_t(q[2])];
        const Vec3 normal = (c - a).cross(surface.vertices[std::size_t(q[3])] - surface.vertices[std::size_t(q[1])]);
        CHECK(normal.dot(Vec3(0.5, 1, 1.5) - 0.5 * (a + c)) > 0);
        for (std::size_t n = 0; n < 4; ++n) edges[{q[n], q[(n + 1) % 4]}] += 1;
    }
    for (const auto& [edge, count] : edges) {
        CHECK(count == 1);
        CHECK(edges.count({edge.second, edge.first}) == 1);
    }
}

TEST_CASE("the wall of a periodic pipe goes on beyond its ends")
{
    core::Pipe p;
    p.core_cells = 4;
    p.wing_cells = 2;
    p.axial_cells = 9;
    p.blocks_along = 1;
    const Mesh mesh(core::make_pipe(p), 0, 1);
    const std::vector<std::string> names{"wall"};
    // A margin of less than one cell of 10 mm adds one ring at each end.
    CHECK(core::boundary_surface(mesh, names, 0.004).quads.size() == 16 * (9 + 2));
    CHECK(core::boundary_surface(mesh, names, 0.004).vertices.size() == 16 * (10 + 2));
}

TEST_CASE("the surface of flat blocks whose points do not match is closed, and so is that of a step")
{
    const auto require_closed = [](core::MultiBlock grid) {
        grid.boundary_name = [](core::BlockId, core::Side) { return std::string("wall"); };
        const Mesh mesh(std::move(grid), 0, 1);
        const auto surface = core::boundary_surface(mesh, std::vector<std::string>{"wall"}, 0.0);
        std::map<std::pair<int, int>, int> edges;
        Vec3 area = Vec3::Zero();
        for (const auto& q : surface.quads)
            for (std::size_t n = 0; n < 4; ++n) {
                const int from = q[n], to = q[(n + 1) % 4];
                if (from == to) continue;
                edges[{from, to}] += 1;
                area += 0.5 * surface.vertices[std::size_t(from)].cross(surface.vertices[std::size_t(to)]);
            }
        int open = 0;
        for (const auto& [edge, count] : edges) open += count != 1 || edges.count({edge.second, edge.first}) != 1;
        CHECK(open == 0);
        CHECK(area.norm() < 1e-12); // of a closed surface; round-off of areas of 1
    };
    const auto as_it_is = [](const Vec3& x) { return x; };
    const core::Box left{{0, 0, 0}, {1, 1, 1}, {3, 4, 4}, {1, 1, 1}, {}}, right{{1, 0, 0}, {2, 1, 1}, {4, 6, 7}, {1, 1, 1}, {}};
    require_closed(test::joined({left, right}, {}, as_it_is));
    const core::Box shallow{{0, 1, 0}, {1, 2, 1}, {3, 3, 4}, {1, 1, 1}, {}}, upper{{1, 1, 0}, {2, 2, 1}, {3, 4, 6}, {1, 1, 1}, {}},
        lower{{1, 0, 0}, {2, 1, 1}, {3, 3, 6}, {1, 1, 1}, {}};
    require_closed(test::joined({shallow, upper, lower}, {}, as_it_is));
}

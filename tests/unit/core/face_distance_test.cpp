// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/box.hpp"
#include "core/grid/face_distance.hpp"
#include "core/grid/pipe.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

using core::Vec3;

namespace {

const std::vector<std::string> box_walls{"y_low", "y_high", "z_low"};

} // namespace

TEST_CASE("the distance to a triangle is that to its plane, an edge or a corner")
{
    const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
    CHECK(core::distance_to_triangle({0.5, 0.5, -3}, a, b, c) == test::relative(3));
    CHECK(core::distance_to_triangle({2, 2, 1}, a, b, c) == test::relative(std::sqrt(3.0)));
    CHECK(core::distance_to_triangle({1, -4, 3}, a, b, c) == test::relative(5));
    CHECK(core::distance_to_triangle({-3, -4, 0}, a, b, c) == test::relative(5));
    CHECK(core::distance_to_triangle({1, 0, 1}, a, b, b) == test::relative(1)); // without area
}

TEST_CASE("in a box of several blocks the distance is that to the nearest wall")
{
    const core::Box box{{0, 0, 0}, {3, 1, 2}, {6, 8, 4}, {2, 2, 1}, {true, false, false}};
    const core::Mesh mesh(core::make_box(box), 0, 1);
    const core::FaceDistance distance(mesh, box_walls);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const auto found = distance.of_cells(mesh.geometry(b));
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const Vec3 x = mesh.geometry(b).centre(i, j, k);
            CHECK(found(i, j, k) == test::relative(std::min({x.y(), 1 - x.y(), x.z()})).epsilon(1e-12));
        });
    }
}

TEST_CASE("distances in cells are the least over all faces and their images, one by one")
{
    const auto bent = [](const Vec3& x) {
        return x + 0.2 * Vec3(0, std::sin(2 * std::numbers::pi * x.x()), 0.5 * std::sin(2 * std::numbers::pi * x.x()));
    };
    core::Box box{{0, 0, 0}, {1, 1, 0.3}, {12, 5, 3}, {3, 1, 1}, {true, false, true}};
    const core::Mesh mesh(core::make_box(box, bent), 0, 1);
    const std::vector<std::string> low{"y_low"};
    const core::FaceDistance distance(mesh, low);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const auto found = distance.of_cells(mesh.geometry(b));
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            double least = 1e9;
            for (core::BlockId other = 0; other < mesh.blocks(); ++other)
                core::for_each({0, 0, 0}, {4, 1, 3}, [&](int m, int n, int o) {
                    const auto q = core::face_corners(mesh.vertices(other), 1, {m, n, o});
                    const Vec3 middle = 0.25 * (q[0] + q[1] + q[2] + q[3]);
                    for (const double along : {-1.0, 0.0, 1.0})
                        for (const double across : {-0.3, 0.0, 0.3})
                            for (std::size_t corner = 0; corner < 4; ++corner)
                                least =
                                    std::min(least, core::distance_to_triangle(mesh.geometry(b).centre(i, j, k) + Vec3(along, 0, across),
                                                                               middle, q[corner], q[(corner + 1) % 4]));
                });
            CHECK(found(i, j, k) == test::relative(least).epsilon(1e-12));
        });
    }
}

TEST_CASE("in a pipe the distance is the radius that is left, to what flat faces cut off")
{
    core::Pipe pipe;
    pipe.diameter = 0.1;
    pipe.core_cells = 16;
    pipe.wing_cells = 8;
    pipe.axial_cells = 4;
    const core::Mesh mesh(core::make_pipe(pipe), 0, 1);
    const std::vector<std::string> wall{"wall"};
    const core::FaceDistance distance(mesh, wall);
    const double cut_off = 0.05 * (1 - std::cos(std::numbers::pi / 64)); // 64 faces round the rim
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const auto found = distance.of_cells(mesh.geometry(b));
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const double left = 0.05 - mesh.geometry(b).centre(i, j, k).tail<2>().norm();
            CHECK(found(i, j, k) <= left * (1 + 1e-12));
            CHECK(found(i, j, k) >= left - 1.01 * cut_off); // wings are not quite even along the rim
        });
    }
}

TEST_CASE("where there is no such boundary the distance is without bound")
{
    const core::Mesh mesh(core::make_box({}), 0, 1);
    CHECK(std::isinf(core::FaceDistance(mesh, std::vector<std::string>{}).at({0.5, 0.5, 0.5})));
}

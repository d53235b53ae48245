// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/mesh.hpp"
#include "physics/coupling/filter.hpp"
#include "physics/fluid/mesh_links.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

namespace {

/// Two blocks of cells that are all the same parallelepiped, joined where i is `split`.
core::MultiBlock sheared_blocks(core::Extents cells, int split, const core::Mat3& edges)
{
    core::MultiBlock grid;
    for (const auto& [first, last] : {std::pair(0, split), std::pair(split, cells.ni)}) {
        core::Vertices v({last - first + 1, cells.nj + 1, cells.nk + 1}, 0, core::Vec3::Zero());
        core::for_each_cell(v.extents(), [&](int i, int j, int k) { v(i, j, k) = edges * core::Vec3(first + i, j, k); });
        grid.blocks.push_back(v);
    }
    return grid;
}

} // namespace

TEST_CASE("on skewed cells, too, the filter spreads a filled cell over the mean square distance of its bandwidth")
{
    const double h = 1e-3, bandwidth = 3e-3, degree = std::numbers::pi / 180;
    core::Mat3 edges; // 55 and 70 degrees between edges of different lengths
    edges.col(0) = h * core::Vec3(1, 0, 0);
    edges.col(1) = 1.2 * h * core::Vec3(std::cos(55 * degree), std::sin(55 * degree), 0);
    edges.col(2) = 0.9 * h * core::Vec3(std::cos(70 * degree), 0, std::sin(70 * degree));
    const core::Extents cells{40, 40, 40};
    const core::Mesh mesh(sheared_blocks(cells, 21, edges), 0, 1);
    const physics::MeshLinks links = physics::make_mesh_links(mesh, 0);
    core::FaceField faces({"spreading", "m", 0, false}, mesh.own_cells());
    core::ScalarField volume({"volume", "m3", 0, false}, mesh.own_cells()), density({"density", "1/m3", 0, false}, mesh.own_cells());
    for (auto* field : {&volume, &density}) field->allocate();
    faces.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        physics::spreading(mesh.geometry(b), faces.on(b));
        core::for_each_cell(mesh.own_cells()[std::size_t(b)],
                            [&](int i, int j, int k) { volume.on(b)(i, j, k) = mesh.geometry(b).volume(i, j, k); });
    }
    const core::SerialTeam team;
    physics::Filter filter(links.topology, {.bandwidth = bandwidth});
    filter.load(team, {&faces, links.spreading, nullptr}, volume);
    filter.set_bound(filter.eigenvalue_bound());
    REQUIRE(filter.degree() < 18); // nothing reaches the boundary
    const core::Vec3 start = mesh.geometry(0).centre(19, 20, 20);
    density.on(0)(19, 20, 20) = 1 / volume.on(0)(19, 20, 20);
    const auto field = [&](core::LocalBlock b, int) { return density.on(b); };
    filter.put(team, 1, field);
    filter.run(team, 1);
    filter.take(team, 1, field);
    double mean_square = 0;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.own_cells()[std::size_t(b)], [&](int i, int j, int k) {
            mean_square += density.on(b)(i, j, k) * volume.on(b)(i, j, k) * (mesh.geometry(b).centre(i, j, k) - start).squaredNorm();
        });
    // bandwidth^2 / 2 in each direction; the rest is round-off.
    CHECK(mean_square == test::relative(1.5 * bandwidth * bandwidth).epsilon(1e-12));
}

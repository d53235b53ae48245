// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/comm/halo.hpp"
#include "core/comm/reduce.hpp"
#include "core/grid/box.hpp"
#include "core/grid/pipe.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

using core::Mesh, core::Vec3;

namespace {

Vec3 wavy(const Vec3& x)
{
    const double pi = std::numbers::pi;
    return x + 0.05 * Vec3(std::sin(2 * pi * x.y()), std::sin(2 * pi * x.z()), std::sin(2 * pi * x.x()));
}

core::Pipe small_pipe()
{
    core::Pipe p;
    p.core_cells = 6;
    p.wing_cells = 4;
    p.axial_cells = 12;
    p.blocks_along = 3;
    return p;
}

} // namespace

TEST_CASE("the faces of every cell close and the cells fill the domain")
{
    const auto check = [](const Mesh& mesh, double volume, double tolerance) {
        double total = 0;
        for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
            const auto& g = mesh.geometry(b);
            core::for_each_cell(g.cells, [&](int i, int j, int k) {
                const Vec3 sum = g.area(0, i + 1, j, k) - g.area(0, i, j, k) + g.area(1, i, j + 1, k) - g.area(1, i, j, k) +
                                 g.area(2, i, j, k + 1) - g.area(2, i, j, k);
                CHECK(sum.norm() < 1e-14 * g.area(0, i, j, k).norm() * 10);
                total += g.volume(i, j, k);
            });
        }
        CHECK(total == test::relative(volume).epsilon(tolerance));
    };
    check(Mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {6, 6, 6}, {2, 3, 1}, {true, true, true}}, wavy), 0, 1), 1.0, 1e-13);
    // A polygon of 24 sides has 1.14 % less area than its circle.
    const double circle = std::numbers::pi * 0.025 * 0.025 * 0.09;
    check(Mesh(core::make_pipe(small_pipe()), 0, 1), circle * 12 / std::numbers::pi * std::sin(std::numbers::pi / 12), 1e-12);
}

TEST_CASE("a butterfly pipe of n axial blocks has 13 n interfaces and 4 n walls")
{
    const Mesh mesh(core::make_pipe(small_pipe()), 0, 1);
    CHECK(mesh.blocks() == 15);
    CHECK(mesh.topology().interfaces.size() == 13 * 3);
    CHECK(mesh.topology().boundaries.size() == 4 * 3);
    for (const auto& boundary : mesh.topology().boundaries) CHECK(boundary.name == "wall");
}

TEST_CASE("maps between blocks are inverse to each other and halo centres lie where the grid goes on")
{
    const Mesh mesh(core::make_pipe(small_pipe()), 0, 1);
    for (const auto& f : mesh.topology().interfaces) {
        const core::Index3 c{-3, 5, 7};
        CHECK(f.a_to_b.inverse()(f.a_to_b(c)) == c);
    }
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const auto& g = mesh.geometry(b);
        // Along the axis, which is j, the cells are uniform, also through the period.
        CHECK((g.centre(1, -1, 1) - g.centre(1, 0, 1) + Vec3(0.09 / 12, 0, 0)).norm() < 1e-15);
        CHECK((g.centre(1, 4, 1) - g.centre(1, 3, 1) - Vec3(0.09 / 12, 0, 0)).norm() < 1e-15);
    }
}

TEST_CASE("halos of a position field repeat the halo centres, and the transpose is the transpose")
{
    const Mesh mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {8, 8, 8}, {2, 2, 2}, {false, false, false}}, wavy), 0, 1);
    const auto world = core::Communicator::world();
    core::VectorField x({"x", "m", 3, false}, mesh.own_cells()), y({"y", "m", 3, false}, mesh.own_cells());
    x.allocate();
    y.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.own_cells()[std::size_t(b)], [&](int i, int j, int k) {
            for (int c = 0; c < 3; ++c) x.on(b).component(c)(i, j, k) = mesh.geometry(b).centre(i, j, k)[c];
        });
    const core::HaloExchange halo(mesh, world, 3, 3, core::HaloShape::full);
    halo.fill(x);
    double left = 0, right = 0;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        for (const auto& row : core::halo_rows(mesh.topology(), mesh.global(b), 3, core::HaloShape::full)) {
            const Vec3 got(x.on(b).x[row.cell], x.on(b).y[row.cell], x.on(b).z[row.cell]);
            CHECK((got - mesh.geometry(b).centre(row.cell.i, row.cell.j, row.cell.k)).norm() < 1e-15);
            y.on(b).x[row.cell] = std::sin(37.0 * row.cell.i + 17.0 * row.cell.j + row.cell.k);
            left += y.on(b).x[row.cell] * x.on(b).x[row.cell];
        }
    }
    halo.add_home(y);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.own_cells()[std::size_t(b)],
                            [&](int i, int j, int k) { right += y.on(b).x(i, j, k) * x.on(b).x(i, j, k); });
    CHECK(left == test::relative(right).epsilon(1e-12));
}

TEST_CASE("round a singular edge both ways are averaged and the cells near it are marked")
{
    const Mesh mesh(core::make_pipe(small_pipe()), 0, 1);
    int averaged = 0;
    for (const auto& row : core::halo_rows(mesh.topology(), 0, 1, core::HaloShape::full)) averaged += row.sources.size() == 2;
    CHECK(averaged == 4 * (4 + 2)); // four edges of the core, four cells long, and their ends beyond
    CHECK(mesh.geometry(0).near_singular(0, 0, 0) == 1);
}

TEST_CASE("a folded cell is refused with its place")
{
    const auto fold = [](const Vec3& x) { return x.x() > 0.4 && x.x() < 0.6 ? Vec3(x - Vec3(0.5, 0, 0)) : x; };
    CHECK_THROWS_WITH_AS(Mesh(core::make_box({{0, 0, 0}, {1, 1, 1}, {4, 4, 4}}, fold), 0, 1),
                         doctest::Contains("cell (1, 0, 0) of block 0"), core::ConfigError);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/halo.hpp"
#include "core/field/sample.hpp"
#include "core/grid/box.hpp"
#include "core/grid/pipe.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <random>
#include <utility>

using core::Locator, core::Mesh, core::Vec3;

namespace {

core::MultiBlock pipe()
{
    core::Pipe p;
    p.core_cells = 6;
    p.wing_cells = 4;
    p.axial_cells = 12;
    p.blocks_along = 3;
    return core::make_pipe(p);
}

/// Random points inside random cells.
std::vector<std::pair<core::Location, Vec3>> places(const Mesh& mesh, const Locator& locator, int count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.001, 0.999);
    std::vector<std::pair<core::Location, Vec3>> all;
    for (int n = 0; n < count; ++n) {
        core::Location at;
        at.block = int(random() % unsigned(mesh.blocks()));
        const auto e = mesh.cells(at.block);
        at.cell = {int(random() % unsigned(e.ni)), int(random() % unsigned(e.nj)), int(random() % unsigned(e.nk))};
        at.xi = Vec3(part(random), part(random), part(random));
        all.emplace_back(at, locator.position(at));
    }
    return all;
}

} // namespace

TEST_CASE("the owner of a point is the rank that owns its cell, whoever asks")
{
    const Mesh first(pipe(), 0, 3), last(pipe(), 2, 3);
    const Locator one(first), other(last);
    for (const auto& [at, x] : places(first, one, 300)) {
        CHECK(one.owner(x) == first.owner(at.block));
        CHECK(other.owner(x) == first.owner(at.block));
    }
}

TEST_CASE("points are found in the cells that hold them, from nothing and from any other cell")
{
    for (const auto& grid : {pipe(), core::make_box({{0, 0, 0}, {1, 1, 1}, {8, 8, 8}, {2, 1, 2}, {true, false, false}}, [](const Vec3& x) {
                                 return Vec3(x.x() + 2 * x.y(), x.y(), x.z() + 0.2 * x.x() * (1 - x.x()));
                             })}) {
        const Mesh mesh(grid, 0, 1);
        const Locator locator(mesh);
        core::Location before;
        for (const auto& [at, x] : places(mesh, locator, 300)) {
            for (const auto& found : {locator.find(x), locator.find(x, before)}) {
                REQUIRE(found);
                CHECK(found->block == at.block);
                CHECK(found->cell == at.cell);
                CHECK((found->xi - at.xi).norm() < 1e-9);
            }
            before = at;
        }
    }
}

TEST_CASE("a point on faces, edges and corners of cells is found with the same bits from any start")
{
    const Mesh mesh(pipe(), 0, 1);
    const Locator locator(mesh);
    core::Location before;
    int number = 0;
    for (auto [at, x] : places(mesh, locator, 300)) {
        ++number;
        for (int m = 0; m < 3; ++m)
            if ((number >> m) & 1) at.xi[m] = std::round(at.xi[m]); // on one, two or three faces
        const auto on_face = locator.position(at);
        const auto direct = locator.find(on_face);
        REQUIRE(direct);
        for (const core::Location& start : {before, at, *direct}) {
            const auto found = locator.find(on_face, start);
            REQUIRE(found);
            CHECK(found->block == direct->block);
            CHECK(found->cell == direct->cell);
            CHECK(found->xi == direct->xi);
        }
        before = at;
    }
}

TEST_CASE("a point that crosses the seam is found at the other end, one outside is not found")
{
    const Mesh mesh(pipe(), 0, 1);
    const Locator locator(mesh);
    const auto last = locator.find(Vec3(0.0899, 0.002, 0.001));
    REQUIRE(last);
    const auto first = locator.find(Vec3(0.0901, 0.002, 0.001), *last);
    REQUIRE(first);
    CHECK((locator.position(*first) - Vec3(0.0001, 0.002, 0.001)).norm() < 1e-12);
    CHECK_FALSE(locator.find(Vec3(0.05, 0.04, 0)));
    CHECK(locator.find(Vec3(0.05, 0.02499, 0)));
}

TEST_CASE("sampling and depositing are transposes and conserve, across blocks, seam and walls")
{
    const Mesh mesh(pipe(), 0, 1);
    const Locator locator(mesh);
    const core::HaloExchange halo(mesh, core::Communicator::world(), 1, 1, core::HaloShape::full);
    core::ScalarField f({"f", "", 1, false}, mesh.own_cells()), q({"q", "", 1, false}, mesh.own_cells());
    f.allocate();
    q.allocate();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.own_cells()[std::size_t(b)], [&](int i, int j, int k) { f.on(b)(i, j, k) = number(random); });
    halo.fill(f);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) core::mirror_even(mesh, b, f.on(b));
    double sampled = 0, deposited = 0, total = 0;
    for (const auto& [at, x] : places(mesh, locator, 500)) {
        const double quantity = number(random);
        const auto stencil = core::hat_stencil(mesh, at);
        sampled += quantity * core::sample(stencil, std::as_const(f).on(stencil.block));
        core::deposit(stencil, quantity, q.on(stencil.block));
        total += quantity;
    }
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) core::mirror_even_transpose(mesh, b, q.on(b));
    halo.add_home(q);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.own_cells()[std::size_t(b)], [&](int i, int j, int k) {
            deposited += f.on(b)(i, j, k) * q.on(b)(i, j, k);
            total -= q.on(b)(i, j, k);
        });
    CHECK(sampled == test::relative(deposited).epsilon(1e-12)); // round-off of some thousand products
    CHECK(std::abs(total) < 1e-12);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/comm/halo.hpp"
#include "core/grid/box.hpp"
#include "tests/support/turned_grids.hpp"
#include <doctest/doctest.h>

using core::Mat3, core::Mesh, core::Vec3;

namespace {

const Vec3 axis = Vec3::UnitX();

/// A vector field that looks the same from every direction across the axis, though not along it.
Vec3 swirl(const Vec3& x) { return (1 + axis.cross(x).squaredNorm()) * axis.cross(x) + x * x.x() + 0.3 * axis; }

/// d swirl_c / d x_m
Mat3 swirl_gradient(const Vec3& x)
{
    Mat3 cross;
    cross << 0, 0, 0, 0, 0, -1, 0, 1, 0;
    const Vec3 across(0, x.y(), x.z());
    return (1 + across.squaredNorm()) * cross + 2 * axis.cross(x) * across.transpose() + x.x() * Mat3::Identity() + x * axis.transpose();
}

/// Largest error beyond the sides of blocks, at the places where the halo says that its cells lie.
double halo_error(core::MultiBlock grid)
{
    const Mesh mesh(std::move(grid), 0, 1);
    core::VectorField v({"v", "", 3, false}, mesh.own_cells());
    core::TensorField g({"g", "", 3, false}, mesh.own_cells());
    core::ScalarField r({"r", "", 3, false}, mesh.own_cells());
    v.allocate(), g.allocate(), r.allocate();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const Vec3 x = mesh.geometry(b).centre(i, j, k);
            r.on(b)(i, j, k) = test::radius(x);
            for (int c = 0; c < 3; ++c) {
                v.on(b).component(c)(i, j, k) = swirl(x)[c];
                for (int m = 0; m < 3; ++m) g.on(b)[std::size_t(c)].component(m)(i, j, k) = swirl_gradient(x)(c, m);
            }
        });
    const core::HaloExchange halo(mesh, core::Communicator::self(), 3, 3, core::HaloShape::full);
    halo.fill(v), halo.fill(g), halo.fill(r);
    double worst = 0;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        for (const core::HaloRow& row : core::halo_rows(mesh.topology(), mesh.global(b), 3, core::HaloShape::full)) {
            const auto [i, j, k] = row.cell;
            const Vec3 x = mesh.geometry(b).centre(i, j, k);
            worst = std::max(worst, std::abs(r.on(b)(i, j, k) - test::radius(x)));
            // Along the axis the field does not repeat.
            if (std::abs(x.x() - 0.5) > 0.5) continue;
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(v.on(b).component(c)(i, j, k) - swirl(x)[c]));
                for (int m = 0; m < 3; ++m)
                    worst = std::max(worst, std::abs(g.on(b)[std::size_t(c)].component(m)(i, j, k) - swirl_gradient(x)(c, m)));
            }
        }
    return worst;
}

} // namespace

TEST_CASE("behind a seam that turns, vectors, gradients and places are those of the neighbour turned")
{
    constexpr double round_off = 1e-13;
    for (const core::Extents blocks : {core::Extents{1, 1, 1}, {2, 1, 2}, {1, 2, 4}})
        CHECK(halo_error(test::ring_sector({4, 4, 4}, blocks)) < round_off);
    // A quarter of a square duct, with the axis on its edge.
    core::MultiBlock quarter = core::make_box({{0, 0, 0}, {1, 1, 1}, {4, 4, 4}, {1, 1, 1}, {true, false, false}});
    quarter.turn = core::PeriodicTurn{axis, Vec3::Zero(), std::numbers::pi / 2};
    CHECK(halo_error(quarter) < round_off);
}

TEST_CASE("the sector of a ring has its neighbours through the turn, and no boundary there")
{
    const Mesh mesh(test::ring_sector({4, 4, 4}, {1, 1, 2}), 0, 1);
    CHECK(mesh.topology().turns());
    CHECK(mesh.topology().boundaries.size() == 4);
    const auto& beyond = mesh.topology().neighbour(0, core::Side::k_low);
    REQUIRE(beyond);
    CHECK(beyond->block == 1);
    const Vec3 x(0.1, 0.7, 0.2);
    CHECK((beyond->motion.of_position(x) - test::turned(x, test::sector_angle)).norm() < 1e-15);
    CHECK((beyond->motion.origin_of(beyond->motion.of_position(x)) - x).norm() < 1e-15);
}

TEST_CASE("a turn about a point shifts and turns, and back again")
{
    const core::Motion m = core::PeriodicTurn{Vec3(0, 0, 1), Vec3(1, 2, 3), std::numbers::pi / 2}.motion();
    CHECK((m.of_position(Vec3(2, 2, 0)) - Vec3(1, 3, 0)).norm() < 1e-15);
    CHECK(m.then(m.inverse()).is_same(core::Motion()));
    CHECK(m.then(core::Motion(Vec3(0, 0, 5))).is_same(core::Motion(Vec3(0, 0, 5)).then(m)));
}

TEST_CASE("a turn that joins nothing, or whose sides have other points, is refused with the sides named")
{
    const auto refusal = [](core::MultiBlock grid) {
        try {
            const Mesh mesh(std::move(grid), 0, 1);
        } catch (const core::ConfigError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    core::MultiBlock wrong = test::ring_sector({4, 4, 4});
    wrong.turn->angle *= 1.1;
    CHECK(refusal(wrong).find("lays no side of the grid on another") != std::string::npos);
    core::MultiBlock graded = core::make_box({{0, 0, 0}, {1, 1, 1}, {4, 4, 4}, {1, 1, 1}, {true, false, false}},
                                             [](const Vec3& x) { return Vec3(x.x(), x.y() * (0.8 + 0.2 * x.y()), x.z()); });
    graded.turn = core::PeriodicTurn{axis, Vec3::Zero(), std::numbers::pi / 2};
    const std::string text = refusal(graded);
    CHECK_MESSAGE(text.find("side k_low of block 0") != std::string::npos, text);
    CHECK(text.find("side j_low of block 0, but their points do not match") != std::string::npos);
    // Half of a duct: the turn lays its flat side on itself.
    core::MultiBlock half = core::make_box({{0, -1, 0}, {1, 1, 1}, {4, 4, 4}, {1, 1, 1}, {true, false, false}});
    half.turn = core::PeriodicTurn{axis, Vec3::Zero(), std::numbers::pi};
    CHECK(refusal(half).find("lays side k_low of block 0 on itself: cut the block at the axis") != std::string::npos);
}

TEST_CASE("half of a duct that is cut at the axis is joined to itself by half a turn")
{
    core::MultiBlock half = core::make_box({{0, -1, 0}, {1, 1, 1}, {4, 4, 4}, {1, 2, 1}, {true, false, false}});
    half.turn = core::PeriodicTurn{axis, Vec3::Zero(), std::numbers::pi};
    CHECK(halo_error(half) < 1e-13);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "core/grid/annulus.hpp"
#include "core/grid/bent_pipe.hpp"
#include "core/grid/mesh.hpp"
#include "core/grid/stepped_channel.hpp"
#include "core/grid/wavy_box.hpp"
#include "tests/support/relative.hpp"
#include <algorithm>
#include <doctest/doctest.h>
#include <numbers>

using core::Mesh, core::Vec3;

namespace {

constexpr double pi = std::numbers::pi;

int count(const Mesh& mesh, const std::string& boundary)
{
    const auto& all = mesh.topology().boundaries;
    return int(std::count_if(all.begin(), all.end(), [&](const core::Boundary& b) { return b.name == boundary; }));
}

core::BentPipe bent(std::vector<core::PipePiece> pieces)
{
    core::BentPipe p;
    p.diameter = 0.04;
    p.core_cells = 4;
    p.wing_cells = 2;
    p.pieces = std::move(pieces);
    return p;
}

core::PipePiece arc(double angle, double radius, const Vec3& towards, int cells = 8) { return {0, angle, radius, towards, cells, 1}; }

/// Area of the polygon with as many corners as the section has vertices on its rim.
double section_area(const core::BentPipe& p)
{
    const double corners = 4.0 * p.core_cells;
    return corners / 2 * std::sin(2 * pi / corners) * p.diameter * p.diameter / 4;
}

} // namespace

TEST_CASE("a wavy box fills its period exactly, and waves that would fold it are refused")
{
    const core::Box box{{0, 0, 0}, {2, 1, 1}, {12, 8, 8}, {2, 2, 1}, {true, true, true}};
    const Mesh mesh(core::make_wavy_box(box, {0.08, 1}), 0, 1);
    CHECK(mesh.total_volume() == test::relative(2.0).epsilon(1e-13));
    CHECK(mesh.topology().boundaries.empty());
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_wavy_box(box, {0.25, 1})), doctest::Contains("fold the box"), core::ConfigError);
}

TEST_CASE("an annulus closes on itself however many blocks lie around it")
{
    for (const int around : {1, 2, 3}) {
        core::Annulus a;
        a.cells = {4, 3, 12};
        a.blocks = {2, 1, around};
        a.growth = 1.5;
        const Mesh mesh(core::make_annulus(a), 0, 1);
        const double sector = std::sin(2 * pi / 12) / (2 * pi / 12); // of 12 straight faces around
        CHECK(mesh.total_volume() == test::relative(pi / 4 * (0.01 - 0.0025) * 0.1 * sector).epsilon(1e-12));
        CHECK(count(mesh, "inner") == 2 * around);
        CHECK(count(mesh, "x_low") == around);
        CHECK(mesh.topology().boundaries.size() == std::size_t(2 * 2 * around + 2 * around));
        const auto& v = mesh.vertices(0);
        CHECK((v(0, 3, 0) - v(0, 2, 0)).norm() / (v(0, 1, 0) - v(0, 0, 0)).norm() == test::relative(1.5).epsilon(1e-12));
    }
}

TEST_CASE("a ring of pipe joins itself and has the volume that Pappus gives")
{
    const auto ring = bent({arc(2 * pi, 0.1, Vec3::UnitY(), 24)});
    const Mesh mesh(core::make_bent_pipe(ring), 0, 1);
    CHECK(count(mesh, "start") == 0);
    CHECK(count(mesh, "wall") == 4);
    // Straight pieces between 24 sections: the axis is a polygon, and its centroid path is shorter by sin(a) / a; sections
    // are congruent and planar, so nothing else is lost.
    const double step = 2 * pi / 24;
    CHECK(mesh.total_volume() == test::relative(section_area(ring) * 2 * pi * 0.1 * std::sin(step) / step).epsilon(1e-6));
}

TEST_CASE("arcs that add up to none make a pipe that repeats along a straight line")
{
    const double a = pi / 6;
    auto wave = bent({arc(a, 0.1, Vec3::UnitY()), arc(2 * a, 0.1, -Vec3::UnitY(), 16), arc(a, 0.1, Vec3::UnitY())});
    wave.periodic = true;
    const auto grid = core::make_bent_pipe(wave);
    REQUIRE(grid.periods.size() == 1);
    CHECK((grid.periods[0] - Vec3(4 * 0.1 * std::sin(a), 0, 0)).norm() < 1e-15);
    const Mesh mesh(grid, 0, 1);
    CHECK(mesh.topology().boundaries.size() == 12);
    CHECK(count(mesh, "wall") == 12);
    wave.pieces.pop_back();
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_bent_pipe(wave)), doctest::Contains("look the same way"), core::ConfigError);
}

TEST_CASE("a pipe bends in space without twist, and impossible pieces are refused by number")
{
    const auto u = bent({{0.1, 0, 0, Vec3::Zero(), 4, 2}, arc(pi / 2, 0.05, Vec3::UnitY()), arc(pi / 2, 0.05, Vec3::UnitZ())});
    const Mesh mesh(core::make_bent_pipe(u), 0, 1);
    CHECK(count(mesh, "start") == 5);
    CHECK(count(mesh, "end") == 5);
    const auto& last = mesh.vertices(mesh.blocks() - 5);
    const Vec3 middle = last(8, 2, 2);
    CHECK((middle - Vec3(0.15, 0.1, 0.05)).norm() < 1e-15); // 0.1 along x, a quarter to y, a quarter to z
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_bent_pipe(bent({arc(1, 0.01, Vec3::UnitY())}))), doctest::Contains("piece 0"),
                         core::ConfigError);
    CHECK_THROWS_WITH_AS(static_cast<void>(core::make_bent_pipe(bent({arc(1, 0.1, Vec3::UnitX())}))), doctest::Contains("own axis"),
                         core::ConfigError);
}

TEST_CASE("a stepped channel has a step and, with periodic ends, a trench")
{
    core::SteppedChannel c;
    c.blocks_along = {1, 2};
    const Mesh open(core::make_stepped_channel(c), 0, 1);
    CHECK(open.total_volume() == test::relative(0.1 * (0.1 * 0.05 + 0.3 * 0.1)).epsilon(1e-13));
    CHECK(open.blocks() == 5);
    CHECK(count(open, "step") == 1);
    CHECK(count(open, "x_low") == 1);
    CHECK(count(open, "x_high") == 2);
    c.periodic_along = c.periodic_across = true;
    const Mesh trench(core::make_stepped_channel(c), 0, 1);
    CHECK(count(trench, "x_low") == 0);
    CHECK(count(trench, "x_high") == 1); // the other wall of the trench
    CHECK(count(trench, "z_low") == 0);
}

TEST_CASE("beyond the edge of a step the halo goes on linearly")
{
    const Mesh mesh(core::make_stepped_channel({}), 0, 1);
    // Block 2 lies behind the shallow part and above the deep one: around the edge of the step it has no cells.
    const auto rows = core::halo_rows(mesh.topology(), 2, 3, core::HaloShape::full);
    const auto row = std::find_if(rows.begin(), rows.end(), [](const core::HaloRow& r) { return r.cell == core::Index3{-2, -3, 4}; });
    REQUIRE(row != rows.end());
    REQUIRE(row->sources.size() == 3);
    double weight = 0;
    for (const auto& s : row->sources) weight += s.weight;
    CHECK(weight == 1);
    const auto& g = mesh.geometry(2);
    CHECK((g.centre(-2, -3, 4) - (g.centre(-2, 0, 4) + g.centre(0, -3, 4) - g.centre(0, 0, 4))).norm() < 1e-15);
    CHECK(g.near_singular(0, 0, 4) == 1);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// What a flow does is the same however its blocks are numbered, counted and cut, and in whatever direction the scene looks, also
// where the range of advected values decides.
#include "physics/fluid/advection_lcsi.hpp"
#include "tests/support/counted_otherwise.hpp"
#include "tests/support/fluid_run.hpp"
#include <Eigen/Geometry>
#include <algorithm>
#include <doctest/doctest.h>

namespace {

using core::Vec3;

constexpr double side = 2 * std::numbers::pi;

/// Turns the scene by 37 degrees, or leaves it.
core::Mat3 turn_by(double degrees)
{
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
}

/// A wavy box, periodic along x and z, between walls along y.
core::MultiBlock wavy_box(core::Extents blocks, const core::Mat3& turn)
{
    const core::Box box{{0, 0, 0}, {side, side, side}, {12, 8, 12}, blocks, {true, false, true}};
    core::MultiBlock grid = core::make_box(box, [&](const Vec3& x) { return Vec3(turn * test::wavy(x, 0.3, 1)); });
    for (Vec3& period : grid.periods) period = turn * period;
    return grid;
}

/// Numbered backwards, each block counted in a way of its own.
core::MultiBlock shuffled(core::MultiBlock grid)
{
    std::reverse(grid.blocks.begin(), grid.blocks.end());
    for (std::size_t b = 0; b < grid.blocks.size(); ++b)
        for (std::size_t times = 0; times < b % 3; ++times) grid.blocks[b] = test::counted_otherwise(grid.blocks[b]);
    grid.boundary_name = [](core::BlockId, core::Side) { return std::string("wall"); };
    return grid;
}

/// Layers that slide over each other and jump from one speed to another within a cell.
Vec3 layers(const Vec3& x)
{
    const double jump = std::sin(x.z()) > 0 ? 1 : -1;
    return {jump * (1 + 0.3 * std::cos(x.x())), 0.4 * std::sin(x.x()) * std::sin(0.5 * x.y()), 0.6 * jump * std::sin(x.y())};
}

physics::FluidParameters water(physics::AdvectionScheme scheme)
{
    physics::FluidParameters water;
    water.viscosity = 1e-4;
    water.tolerances.pressure = water.tolerances.viscosity = 1e-13;
    water.tolerances.pressure_change = 1e-12;
    water.advection = scheme;
    return water;
}

/// Share of the cells whose advected velocity was kept in range in the last step.
double share_in_range(test::FluidRun& run)
{
    const auto& fields = std::as_const(run.fluid()).fields();
    return run.mean([&](core::LocalBlock b, int i, int j, int k) {
        static thread_local core::VectorField free({"advected freely", "m/s", 0, false}, run.mesh().own_cells());
        free.allocate();
        if (i == 0 && j == 0 && k == 0)
            physics::advect(run.mesh().geometry(b), fields.source.on(b), fields.displacement.on(b), {}, free.on(b));
        const core::VectorView<const double> kept = fields.advected.on(b), all = free.on(b);
        return std::hypot(kept.x(i, j, k) - all.x(i, j, k), kept.y(i, j, k) - all.y(i, j, k), kept.z(i, j, k) - all.z(i, j, k)) > 1e-6;
    });
}

/// Largest difference of velocity between the wavy box of two blocks and another grid of it after ten steps.
double difference(core::MultiBlock other, const core::Mat3& turn, physics::AdvectionScheme scheme)
{
    const core::Mat3 straight = core::Mat3::Identity();
    test::FluidRun one(wavy_box({2, 1, 1}, straight), water(scheme)), two(std::move(other), water(scheme));
    one.start(layers);
    two.start([&](const Vec3& x) { return Vec3(turn * layers(turn.transpose() * x)); });
    const double dt = 0.5 / one.outflow_rate();
    for (int n = 0; n < 10; ++n) {
        one.step(dt);
        two.step(dt);
    }
    if (scheme == physics::AdvectionScheme::lcsi) CHECK(share_in_range(one) > 0.05);
    std::vector<std::pair<Vec3, Vec3>> cells; // place and velocity
    for (core::LocalBlock b = 0; b < two.mesh().own_count(); ++b)
        core::for_each_cell(two.mesh().geometry(b).cells, [&](int i, int j, int k) {
            cells.emplace_back(turn.transpose() * two.centre(b, i, j, k), turn.transpose() * two.velocity(b, i, j, k));
        });
    return one.largest([&](core::LocalBlock b, int i, int j, int k) {
        const Vec3 place = one.centre(b, i, j, k);
        const auto same = std::find_if(cells.begin(), cells.end(), [&](const auto& c) { return (c.first - place).norm() < 1e-9; });
        return same == cells.end() ? 1e9 : (one.velocity(b, i, j, k) - same->second).norm();
    });
}

} // namespace

TEST_CASE("a flow stays the same when blocks are renumbered, counted otherwise, cut again, and when the scene is turned by 37 degrees")
{
    const core::Mat3 straight = core::Mat3::Identity(), turn = turn_by(37);
    for (const auto scheme : {physics::AdvectionScheme::lcsi, physics::AdvectionScheme::finite_volume}) {
        const std::array differences{difference(shuffled(wavy_box({2, 1, 1}, straight)), straight, scheme),
                                     difference(wavy_box({2, 1, 2}, straight), straight, scheme),
                                     difference(wavy_box({2, 1, 1}, turn), turn, scheme),
                                     difference(shuffled(wavy_box({2, 2, 2}, turn)), turn, scheme)};
        for (const double d : differences) {
            MESSAGE("largest difference ", d);
            CHECK(d < 1e-10); // of speeds of 1.3; solvers are exact to 1e-13
        }
    }
}

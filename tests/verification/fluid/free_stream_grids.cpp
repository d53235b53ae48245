// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Every generator's grid keeps a uniform flow uniform (NUMERICS C0 U3), and the way in which blocks count changes no flow.
#include "core/grid/annulus.hpp"
#include "core/grid/bent_pipe.hpp"
#include "core/grid/elliptic_grid.hpp"
#include "core/grid/stepped_channel.hpp"
#include "tests/support/counted_otherwise.hpp"
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

/// Largest displacement in cells per unit of time, of all blocks.
double displacement_rate(test::FluidRun& run)
{
    double largest = 0;
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b)
        largest = std::max(largest, physics::transport_rates(run.mesh().geometry(b), run.fluid().state().velocity.on(b)).displacement);
    return largest;
}

/// Largest change of velocity after 20 steps in which the flow crosses up to 0.5 cells each; beside smaller cells its way is
/// longer, all walls moving with it.
double change(core::MultiBlock grid, physics::AdvectionScheme scheme = physics::AdvectionScheme::lcsi)
{
    const Vec3 uniform(0.7, -0.4, 0.5);
    physics::FluidParameters water;
    water.viscosity = 1e-3;
    water.advection = scheme;
    for (const core::Boundary& b : core::match_sides(grid).boundaries) water.boundaries[b.name].velocity = uniform;
    test::FluidRun run(std::move(grid), water);
    run.start([&](const Vec3&) { return uniform; });
    const double dt = std::min(0.5 / displacement_rate(run), 0.9 / run.outflow_rate());
    for (int n = 0; n < 20; ++n) run.step(dt);
    return run.largest([&](core::LocalBlock b, int i, int j, int k) { return (run.velocity(b, i, j, k) - uniform).norm(); });
}

core::BentPipe waving_pipe()
{
    core::BentPipe pipe;
    pipe.diameter = 1;
    pipe.core_cells = 4;
    pipe.wing_cells = 2;
    const double a = std::numbers::pi / 6;
    pipe.pieces = {{0, a, 2.5, Vec3::UnitY(), 6, 1}, {0, 2 * a, 2.5, -Vec3::UnitY(), 12, 1}, {0, a, 2.5, Vec3::UnitY(), 6, 1}};
    pipe.periodic = true;
    return pipe;
}

core::MultiBlock wavy_box()
{
    const double length = 2 * std::numbers::pi;
    const core::Box box{{0, 0, 0}, {length, length, length}, {12, 8, 12}, {2, 1, 2}, {true, true, true}};
    return core::make_box(box, [](const Vec3& x) { return test::wavy(x, 0.3, 1); });
}

Vec3 vortices(const Vec3& x)
{
    return {std::sin(x.x()) * std::cos(x.y()), -std::cos(x.x()) * std::sin(x.y()), 0.2 * std::sin(x.x() + x.y())};
}

} // namespace

TEST_CASE("a uniform flow stays uniform on the grid of every generator")
{
    CHECK(change(core::make_annulus({0.5, 1, 1, {6, 4, 18}, {1, 1, 3}, 1.4, true})) < 1e-12);
    CHECK(change(core::make_bent_pipe(waving_pipe())) < 1e-12);
    core::SteppedChannel trench;
    trench.periodic_along = trench.periodic_across = true;
    CHECK(change(core::make_stepped_channel(trench)) < 1e-12);
}

TEST_CASE(
    "a uniform flow stays uniform in finite volumes on the grid of every generator, and in wavy turned boxes whose points do not match")
{
    constexpr auto scheme = physics::AdvectionScheme::finite_volume;
    CHECK(change(core::make_annulus({0.5, 1, 1, {6, 4, 18}, {1, 1, 3}, 1.4, true}), scheme) < 1e-12);
    CHECK(change(core::make_bent_pipe(waving_pipe()), scheme) < 1e-12);
    core::SteppedChannel trench;
    trench.periodic_along = trench.periodic_across = true;
    CHECK(change(core::make_stepped_channel(trench), scheme) < 1e-12);
    for (const auto advection : {scheme, physics::AdvectionScheme::lcsi})
        CHECK(change(test::wavy_halves({{5, 8, 8}, {6, 12, 20}}, 0.3, 37), advection) < 1e-12);
}

TEST_CASE("a uniform flow stays uniform where three curved sides with points of their own meet along a line, whatever carries it")
{
    for (const auto advection : {physics::AdvectionScheme::lcsi, physics::AdvectionScheme::finite_volume})
        for (const double curvature : {0.05, -0.05}) CHECK(change(test::two_on_one(curvature), advection) < 1e-12);
}

TEST_CASE("a uniform flow stays uniform on elliptic grids with thin cells at the walls")
{
    core::MultiBlock grid = core::make_bent_pipe(waving_pipe());
    core::EllipticGrid wanted;
    wanted.spacings = {{"wall", 0.08, 3}};
    core::make_elliptic(grid, wanted);
    CHECK(change(std::move(grid)) < 1e-12);
}

TEST_CASE("a flow does not depend on the order of the blocks or on how each of them counts")
{
    physics::FluidParameters water;
    water.viscosity = 1e-2;
    water.tolerances.pressure = 1e-13;
    core::MultiBlock grid = wavy_box(), other = grid;
    std::swap(other.blocks[0], other.blocks[3]); // block b of one is block 3 - b of the other for b = 0 and 3
    other.blocks[0] = test::counted_otherwise(other.blocks[0]);
    other.blocks[1] = test::counted_otherwise(test::counted_otherwise(other.blocks[1]));
    test::FluidRun one(std::move(grid), water), two(std::move(other), water);
    one.start(vortices);
    two.start(vortices);
    const double dt = 0.5 / displacement_rate(one);
    for (int n = 0; n < 10; ++n) {
        one.step(dt);
        two.step(dt);
    }
    const auto there = [&](int b, int i, int j, int k) {
        const core::Extents n = one.mesh().cells(b);
        if (b == 3) return two.velocity(0, k, n.ni - 1 - i, n.nj - 1 - j);
        if (b == 0) return two.velocity(3, i, j, k);
        if (b == 2) return two.velocity(2, i, j, k);
        // Turned twice: (i, j, k) -> (k, -i, -j) -> (-j, -k, i).
        return two.velocity(1, n.nj - 1 - j, n.nk - 1 - k, i);
    };
    const double largest =
        one.largest([&](core::LocalBlock b, int i, int j, int k) { return (one.velocity(b, i, j, k) - there(b, i, j, k)).norm(); });
    MESSAGE("largest difference " << largest);
    CHECK(largest < 1e-10);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// One sector whose ends are joined by a turn does what each sector of the whole does: cells are the same, so only round-off and
// what solvers leave may differ.
#include "tests/support/turned_grids.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::AdvectionScheme;

/// Steps at half the largest outflow, and the speed of the fastest cell over them.
void run_both(test::FluidRun& whole, test::FluidRun& part, int steps)
{
    const double dt = 0.5 / whole.outflow_rate();
    for (int n = 0; n < steps; ++n) {
        whole.step(dt);
        part.step(dt);
    }
}

/// Largest difference between sector n of the ring, its block n, and the only block of the part.
double difference(const test::FluidRun& ring, const test::FluidRun& part)
{
    double worst = 0;
    for (core::LocalBlock b = 0; b < ring.mesh().own_count(); ++b)
        core::for_each_cell(ring.mesh().geometry(b).cells, [&](int i, int j, int k) {
            const Vec3 expected = test::turned(part.velocity(0, i, j, k), b * test::sector_angle);
            worst = std::max(worst, (ring.velocity(b, i, j, k) - expected).norm());
        });
    return worst;
}

constexpr core::Extents cells{6, 6, 4};

} // namespace

TEST_CASE("an unsteady flow with waves in each sector is the same in one sector as in the ring, by any advection and viscosity")
{
    for (const auto scheme : {AdvectionScheme::lcsi, AdvectionScheme::lcsi_spline, AdvectionScheme::finite_volume})
        for (const double viscosity : {0.0, 1e-3, 0.3, 30.0}) {
            const auto liquid = test::between_cylinders(viscosity, scheme);
            test::FluidRun ring(test::whole_ring(cells), liquid), part(test::ring_sector(cells), liquid);
            ring.start(test::wavy_swirl);
            part.start(test::wavy_swirl);
            run_both(ring, part, 10);
            const double apart = difference(ring, part);
            MESSAGE("scheme ", int(scheme), ", viscosity ", viscosity, ": ", apart);
            CHECK(apart < 1e-10); // solvers leave 1e-13 in each step
            // Through a seam that turns, momentum is kept along the axis.
            if (scheme == AdvectionScheme::finite_volume) CHECK(std::abs(part.budget().advection.x()) < 1e-13);
        }
}

TEST_CASE("so it is beside walls without friction, and where the flow along the axis is prescribed")
{
    auto liquid = test::between_cylinders(1e-2, AdvectionScheme::lcsi);
    liquid.boundaries["outer"].kind = physics::BoundaryKind::slip;
    liquid.drive = physics::FlowDrive{Vec3::UnitX(), 0.4, physics::SteadyCourse{}, physics::FlowDrive::Measure::bulk_velocity};
    test::FluidRun ring(test::whole_ring(cells), liquid), part(test::ring_sector(cells), liquid);
    ring.start(test::wavy_swirl);
    part.start(test::wavy_swirl);
    run_both(ring, part, 6);
    CHECK(difference(ring, part) < 1e-10);
    const double bulk = part.mean([&](core::LocalBlock b, int i, int j, int k) { return part.velocity(b, i, j, k).x(); });
    CHECK(std::abs(bulk - 0.4) < 1e-3); // what flows through faces is exact, the mean over cells nearly so
}

TEST_CASE("so it is with turbulence and a scalar, walls seen through functions or resolved")
{
    for (const auto walls : {physics::WallTreatment::functions, physics::WallTreatment::resolved}) {
        auto liquid = test::between_cylinders(1e-3, AdvectionScheme::lcsi);
        liquid.drive = physics::ConstantDrive{Vec3(0.2, 0, 0)};
        const test::Carried carried{.scalars = {{.name = "dye", .diffusivity = 1e-3}},
                                    .turbulence = physics::TurbulenceParameters{physics::turbulence_of(1.0, 0.1, 0.05), {}, 0.0, walls}};
        const auto run = [&](core::MultiBlock grid) {
            auto made = std::make_unique<test::FluidRun>(std::move(grid), liquid, tasks::ExecutorOptions{.kind = "serial"},
                                                         core::Communicator::self(), carried);
            made->start(test::wavy_swirl);
            for (core::LocalBlock b = 0; b < made->mesh().own_count(); ++b)
                core::for_each_cell(made->mesh().geometry(b).cells, [&](int i, int j, int k) {
                    const Vec3 x = made->centre(b, i, j, k);
                    made->scalars().fields().values[0].on(b)(i, j, k) = 1 + std::sin(test::sectors * std::atan2(x.z(), x.y())) * x.x();
                });
            return made;
        };
        const auto ring = run(test::whole_ring(cells)), part = run(test::ring_sector(cells));
        run_both(*ring, *part, 6);
        CHECK(difference(*ring, *part) < 1e-8); // solvers of turbulence leave 1e-8
        const auto apart = [&](auto value) {
            return ring->largest(
                [&](core::LocalBlock b, int i, int j, int k) { return value(*ring, b, i, j, k) - value(*part, 0, i, j, k); });
        };
        CHECK(apart([](auto& r, auto b, int i, int j, int k) { return r.turbulence().k().on(b)(i, j, k); }) < 1e-8);
        CHECK(apart([](auto& r, auto b, int i, int j, int k) { return r.turbulence().epsilon().on(b)(i, j, k); }) < 1e-7);
        CHECK(apart([](auto& r, auto b, int i, int j, int k) { return r.scalars().fields().values[0].on(b)(i, j, k); }) < 1e-8);
    }
}

TEST_CASE("a quarter of a square duct whose flow swirls about its edge is that of the whole duct")
{
    physics::FluidParameters liquid;
    liquid.viscosity = 1e-2;
    liquid.tolerances.pressure = liquid.tolerances.viscosity = 1e-13;
    liquid.tolerances.pressure_change = 1e-12;
    const core::Box duct{{0, -1, -1}, {1, 1, 1}, {4, 12, 12}, {1, 2, 2}, {true, false, false}};
    core::MultiBlock quarter = core::make_box({{0, 0, 0}, {1, 1, 1}, {4, 6, 6}, {1, 1, 1}, {true, false, false}});
    quarter.turn = core::PeriodicTurn{Vec3::UnitX(), Vec3::Zero(), std::numbers::pi / 2};
    test::FluidRun whole(core::make_box(duct), liquid), part(std::move(quarter), liquid);
    const auto swirl = [](const Vec3& x) {
        const double wall = std::cos(0.5 * std::numbers::pi * x.y()) * std::cos(0.5 * std::numbers::pi * x.z());
        return Vec3(wall * Vec3(0.3 * std::cos(2 * std::numbers::pi * x.x()), 0, 0) + wall * Vec3::UnitX().cross(x));
    };
    whole.start(swirl);
    part.start(swirl);
    run_both(whole, part, 10);
    constexpr core::LocalBlock same = 3; // the block where y and z are positive
    const double worst = part.largest(
        [&](core::LocalBlock b, int i, int j, int k) { return (part.velocity(b, i, j, k) - whole.velocity(same, i, j, k)).norm(); });
    CHECK(worst < 1e-10);
}

TEST_CASE("one of six sectors that meet on the axis is like each of the six, though more than four cells meet there")
{
    physics::FluidParameters liquid;
    liquid.viscosity = 1e-2;
    liquid.tolerances.pressure = liquid.tolerances.viscosity = 1e-13;
    liquid.tolerances.pressure_change = 1e-12;
    const double angle = std::numbers::pi / 3;
    const core::Box box{{0, 0, 0}, {1, 1, 1}, {4, 6, 6}, {1, 1, 1}, {true, false, false}};
    const auto sector = [&](int n) {
        return core::make_box(box, [&](const Vec3& x) {
            return test::turned(Vec3(x.x(), x.y() + std::cos(angle) * x.z(), std::sin(angle) * x.z()), n * angle);
        });
    };
    core::MultiBlock star = sector(0), one = sector(0);
    for (int n = 1; n < 6; ++n) star.blocks.push_back(sector(n).blocks.front());
    one.turn = core::PeriodicTurn{Vec3::UnitX(), Vec3::Zero(), angle};
    test::FluidRun whole(std::move(star), liquid), part(std::move(one), liquid);
    const auto swirl = [&](const Vec3& x) {
        const double r2 = x.y() * x.y() + x.z() * x.z(), fading = std::exp(-4 * r2);
        return Vec3(fading * (Vec3::UnitX().cross(x) + Vec3(0.3 * std::cos(2 * std::numbers::pi * x.x()), 0, 0)));
    };
    whole.start(swirl);
    part.start(swirl);
    run_both(whole, part, 10);
    const double worst = whole.largest([&](core::LocalBlock b, int i, int j, int k) {
        return (whole.velocity(b, i, j, k) - test::turned(part.velocity(0, i, j, k), b * angle)).norm();
    });
    CHECK(worst < 1e-10);
}

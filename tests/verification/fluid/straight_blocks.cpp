// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=120
// What straight meshes leave out is nothing: bent by less than anybody sees, the general way gives the same flow.
#include "core/grid/box.hpp"
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

constexpr int cells = 12;

/// A lid above stretched blocks, wall to wall; each place moved by about `bend`.
test::FluidRun make_run(double bend, const std::string& far_side)
{
    const auto place = [bend](const Vec3& x) {
        const Vec3 stretched(x.x(), x.y() * (1.5 - 0.5 * x.y()), x.z());
        return Vec3(stretched + bend * Vec3(std::sin(5 * x.y()), std::sin(4 * x.z()), std::sin(3 * x.x())));
    };
    physics::FluidParameters parameters;
    parameters.density = 1;
    parameters.viscosity = 0.02;
    parameters.boundaries["y_high"].velocity = Vec3(1, 0, 0);
    if (far_side == "pressure") parameters.boundaries["x_high"].kind = physics::BoundaryKind::pressure;
    parameters.tolerances.pressure = 1e-11; // both ways solve to it
    return test::FluidRun(core::make_box({Vec3::Zero(), Vec3::Ones(), {cells, cells, cells}, {2, 2, 1}}, place), parameters);
}

} // namespace

TEST_CASE("a straight mesh and one bent by 1e-9 of its size have the same flow")
{
    constexpr double bend = 1e-9;
    for (const std::string far_side : {"wall", "pressure"}) {
        CAPTURE(far_side);
        test::FluidRun straight = make_run(0, far_side), bent = make_run(bend, far_side);
        CHECK(straight.fluid().is_straight());
        CHECK(!bent.fluid().is_straight());
        for (auto* run : {&straight, &bent}) {
            run->start([](const Vec3&) { return Vec3(Vec3::Zero()); });
            for (int n = 0; n < 10; ++n) run->step(0.05);
        }
        const double difference = straight.largest(
            [&](core::LocalBlock b, int i, int j, int k) { return (straight.velocity(b, i, j, k) - bent.velocity(b, i, j, k)).norm(); });
        const double fastest =
            straight.largest([&](core::LocalBlock b, int i, int j, int k) { return straight.velocity(b, i, j, k).norm(); });
        MESSAGE("largest difference over the largest speed: ", difference / fastest);
        CHECK(fastest > 0.3);
        CHECK(difference < 100 * bend * fastest); // the bend over the size of a cell, times the changes of speed from cell to cell
    }
}

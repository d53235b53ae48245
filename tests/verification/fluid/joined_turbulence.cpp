// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2
// Turbulence, and the viscosity it adds, through sides whose points do not match.
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

constexpr double height = 0.02, half = 0.1; // [m]

/// A channel between walls, driven and repeated along x and z, in two halves along x.
std::unique_ptr<test::FluidRun> channel(const test::Halves& cells, const tasks::ExecutorOptions& executor, const core::Communicator& ranks)
{
    physics::FluidParameters water;
    water.viscosity = 1e-6;
    water.drive = physics::ConstantDrive{Vec3(0.3, 0, 0)};
    const test::Carried carried{.turbulence = physics::TurbulenceParameters{physics::turbulence_of(0.7, 0.05, 1e-3), {}, 0.0}};
    const core::Box first{{0, 0, 0}, {half, height, 0.01}, cells.first, {1, 1, 1}, {}};
    const core::Box second{{half, 0, 0}, {2 * half, height, 0.01}, cells.second, {1, 1, 1}, {}};
    const auto grid = test::joined({first, second}, {2 * half * Vec3::UnitX(), 0.01 * Vec3::UnitZ()}, [](const Vec3& x) { return x; });
    auto run = std::make_unique<test::FluidRun>(grid, water, executor, ranks, carried);
    run->start([](const Vec3& x) { return Vec3(0.7 * (1 + 0.1 * std::sin(500 * x.z()) * x.y() / height), 0, 0); });
    return run;
}

} // namespace

TEST_CASE("a turbulent flow that does not vary along a side is that of blocks that match")
{
    const core::Communicator here = core::Communicator::self();
    const auto alike = channel({{4, 10, 2}, {4, 10, 2}}, {.kind = "serial"}, here),
               joined = channel({{4, 10, 2}, {4, 10, 3}}, {.kind = "serial"}, here);
    for (test::FluidRun* run : {alike.get(), joined.get()}) {
        run->start([](const Vec3&) { return Vec3(0.7, 0, 0); });
        for (int n = 0; n < 40; ++n) run->step(0.02);
    }
    double velocity = 0, k = 0, across = 0;
    core::for_each_cell({4, 10, 2}, [&](int i, int j, int m) {
        velocity = std::max(velocity, (joined->velocity(0, i, j, m) - alike->velocity(0, i, j, m)).norm() / 0.7);
        k = std::max(k, std::abs(joined->turbulence().k().on(0)(i, j, m) / alike->turbulence().k().on(0)(i, j, m) - 1));
    });
    core::for_each_cell({4, 10, 3}, [&](int i, int j, int m) {
        across = std::max(across, std::abs(joined->turbulence().k().on(1)(i, j, m) / joined->turbulence().k().on(0)(0, j, 0) - 1));
    });
    MESSAGE("velocity off by ", velocity, ", k by ", k, ", between the halves ", across);
    CHECK(velocity < 1e-6); // forty solves to 1e-8
    CHECK(k < 1e-6);
    CHECK(across < 1e-6);
}

TEST_CASE("two ranks and one have the same bits of turbulence on blocks whose points do not match, whoever executes")
{
    const test::Halves cells{{4, 8, 4}, {5, 12, 6}};
    const auto alone = channel(cells, {.kind = "serial"}, core::Communicator::self());
    for (int n = 0; n < 5; ++n) alone->step(0.01);
    for (const char* kind : {"serial", "tbb"}) {
        const auto together = channel(cells, {.kind = kind, .threads = 2}, core::Communicator::world());
        for (int n = 0; n < 5; ++n) together->step(0.01);
        REQUIRE(together->mesh().own_count() == 1);
        const core::LocalBlock other = alone->mesh().local(together->mesh().global(0));
        int differences = 0;
        core::for_each_cell(together->mesh().geometry(0).cells, [&](int i, int j, int k) {
            differences += together->turbulence().k().on(0)(i, j, k) != alone->turbulence().k().on(other)(i, j, k);
            differences += together->turbulence().epsilon().on(0)(i, j, k) != alone->turbulence().epsilon().on(other)(i, j, k);
            differences += together->velocity(0, i, j, k) != alone->velocity(other, i, j, k);
        });
        CHECK_MESSAGE(differences == 0, kind);
    }
}

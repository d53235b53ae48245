// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=300
// Turbulence beside a flow that is being computed: decay in a box, flow that reverses in a pipe, any ranks and executors.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

/// A pipe whose flow is reversed once in 2 s, in the range of NUMERICS C2.3.
std::unique_ptr<test::FluidRun> swaying(const tasks::ExecutorOptions& executor, const core::Communicator& ranks,
                                        physics::WallTreatment walls = physics::WallTreatment::functions)
{
    physics::FluidParameters water;
    water.viscosity = 1e-6;
    water.tolerances.pressure = 1e-9;
    water.drive = physics::harmonic_drive(Vec3(4, 0, 0), std::numbers::pi, 0.0);
    const test::Carried carried{.turbulence = physics::TurbulenceParameters{physics::turbulence_of(1.0, 0.05, 1e-3), {}, 0.0, walls}};
    auto run = std::make_unique<test::FluidRun>(test::pipe_across(16, 0.06, 4, 2), water, executor, ranks, carried);
    run->start([](const Vec3& x) { return Vec3(0.2 * (1 + 0.1 * std::sin(100 * x.x())), 0, 0); });
    return run;
}

} // namespace

TEST_CASE("turbulence in fluid at rest decays by its power law, however long the step")
{
    for (const double dt : {0.1, 1e6}) {
        physics::FluidParameters water;
        const physics::Turbulence initial{0.02, 0.3};
        const test::Carried carried{.turbulence = physics::TurbulenceParameters{initial, {}, 0.0}};
        const core::Box box{{0, 0, 0}, {1, 1, 1}, {8, 8, 8}, {2, 1, 1}, {true, true, true}};
        test::FluidRun run(core::make_box(box), water, {.kind = "serial"}, core::Communicator::world(), carried);
        run.start([](const Vec3&) { return Vec3(0, 0, 0); });
        for (int n = 0; n < 10; ++n) run.step(dt);
        const double left = std::pow(1 + 0.92 * 10 * dt * initial.epsilon / initial.k, -1 / 0.92) * initial.k;
        const double worst =
            run.largest([&](core::LocalBlock b, int i, int j, int k) { return run.turbulence().k().on(b)(i, j, k) / left - 1; });
        CHECK(worst < 1e-10); // the solver leaves 1e-12 in each step
    }
}

TEST_CASE("a turbulent flow reverses without its turbulence growing beyond bounds or vanishing")
{
    const auto run = swaying({.kind = "serial"}, core::Communicator::world());
    double slowest = 1e9, fastest = 0, most_turbulence = 0;
    for (int n = 0; n < 400; ++n) {
        run->step(0.005);
        const double speed = run->mean([&](core::LocalBlock b, int i, int j, int k) { return run->velocity(b, i, j, k).x(); });
        slowest = std::min(slowest, speed);
        fastest = std::max(fastest, speed);
        const auto& k = run->turbulence().k();
        const auto& epsilon = run->turbulence().epsilon();
        const double sick = run->largest([&](core::LocalBlock b, int i, int j, int m) {
            const bool sound = k.on(b)(i, j, m) > 0 && epsilon.on(b)(i, j, m) > 0 && std::isfinite(k.on(b)(i, j, m)) &&
                               std::isfinite(epsilon.on(b)(i, j, m));
            return sound ? 0.0 : 1.0;
        });
        CHECK(sick == 0.0);
        most_turbulence =
            std::max(most_turbulence, run->largest([&](core::LocalBlock b, int i, int j, int m) { return k.on(b)(i, j, m); }));
    }
    MESSAGE("mean speed from ", slowest, " to ", fastest, " m/s, largest k ", most_turbulence, " m2/s2");
    CHECK(slowest < 0);
    CHECK(fastest < 4 / std::numbers::pi + 0.25); // the drive without any friction, and the start
    CHECK(most_turbulence < 0.1 * fastest * fastest);
}

TEST_CASE("two ranks and one have the same bits of turbulence, whoever executes")
{
    for (const auto walls : {physics::WallTreatment::functions, physics::WallTreatment::resolved}) {
        const auto alone = swaying({.kind = "serial"}, core::Communicator::self(), walls);
        for (int n = 0; n < 6; ++n) alone->step(0.01);
        for (const char* kind : {"serial", "shuffle:3", "tbb", "openmp"}) {
            const auto together = swaying({.kind = kind, .threads = 2}, core::Communicator::world(), walls);
            for (int n = 0; n < 6; ++n) together->step(0.01);
            int differences = 0;
            for (core::LocalBlock b = 0; b < together->mesh().own_count(); ++b) {
                const core::LocalBlock other = alone->mesh().local(together->mesh().global(b));
                core::for_each_cell(together->mesh().geometry(b).cells, [&](int i, int j, int k) {
                    differences += together->turbulence().k().on(b)(i, j, k) != alone->turbulence().k().on(other)(i, j, k);
                    differences += together->turbulence().epsilon().on(b)(i, j, k) != alone->turbulence().epsilon().on(other)(i, j, k);
                    differences += together->velocity(b, i, j, k) != alone->velocity(other, i, j, k);
                });
            }
            CHECK_MESSAGE(differences == 0, kind);
        }
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=300
// Blocks whose points do not match have the same bits on one rank and on two, and with any executor (NUMERICS B12).
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

core::Vec3 vortices(const core::Vec3& x)
{
    return {std::sin(x.x()) * std::cos(x.y()), -std::cos(x.x()) * std::sin(x.y()), 0.2 * std::sin(x.x() + x.y())};
}

std::unique_ptr<test::FluidRun> run_on(const tasks::ExecutorOptions& executor, const core::Communicator& ranks)
{
    physics::FluidParameters water;
    water.viscosity = 0.01;
    auto run = std::make_unique<test::FluidRun>(test::wavy_halves({{6, 8, 6}, {4, 12, 9}}, 0.3, 0), water, executor, ranks);
    run->start(vortices);
    for (int n = 0; n < 4; ++n) run->step(0.1);
    return run;
}

} // namespace

TEST_CASE("two ranks and one have the same bits on blocks whose points do not match, whoever executes")
{
    const auto alone = run_on({.kind = "serial"}, core::Communicator::self());
    for (const char* kind : {"serial", "shuffle:3", "tbb", "openmp"}) {
        const auto together = run_on({.kind = kind, .threads = 2}, core::Communicator::world());
        REQUIRE(together->mesh().own_count() == 1);
        const core::LocalBlock there = alone->mesh().local(together->mesh().global(0));
        int differences = 0;
        core::for_each_cell(together->mesh().geometry(0).cells, [&](int i, int j, int k) {
            differences += together->velocity(0, i, j, k) != alone->velocity(there, i, j, k);
            differences += together->fluid().state().pressure.on(0)(i, j, k) != alone->fluid().state().pressure.on(there)(i, j, k);
        });
        CHECK_MESSAGE(differences == 0, kind);
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=300
// The fluid has the same bits on one rank and on two, and with any executor (NUMERICS B12).
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

core::Vec3 swirl(const core::Vec3& x)
{
    const double fade = 1 - x.tail<2>().squaredNorm();
    return fade * core::Vec3(1 + 0.3 * std::sin(std::numbers::pi * x.x()), -x.z() + 0.2 * std::cos(std::numbers::pi * x.x()), x.y());
}

std::unique_ptr<test::FluidRun> pipe_run(const tasks::ExecutorOptions& executor, const core::Communicator& ranks)
{
    physics::FluidParameters water;
    water.viscosity = 0.01;
    water.drive = physics::ConstantDrive{core::Vec3(0.5, 0, 0)};
    auto run = std::make_unique<test::FluidRun>(test::pipe_across(8, 2.0, 8, 2), water, executor, ranks);
    run->start(swirl);
    for (int n = 0; n < 4; ++n) run->step(0.1);
    return run;
}

/// Cells of the blocks of `part` where any bit of velocity or pressure differs from `whole`.
int differences(const test::FluidRun& part, const test::FluidRun& whole)
{
    int count = 0;
    for (core::LocalBlock b = 0; b < part.mesh().own_count(); ++b) {
        const core::LocalBlock other = whole.mesh().local(part.mesh().global(b));
        core::for_each_cell(part.mesh().geometry(b).cells, [&](int i, int j, int k) {
            count += part.velocity(b, i, j, k) != whole.velocity(other, i, j, k);
            count += part.fluid().state().pressure.on(b)(i, j, k) != whole.fluid().state().pressure.on(other)(i, j, k);
        });
    }
    return count;
}

} // namespace

TEST_CASE("two ranks and one have the same bits, whoever executes")
{
    const auto alone = pipe_run({.kind = "serial"}, core::Communicator::self());
    for (const char* kind : {"serial", "shuffle:3", "tbb", "openmp"}) {
        const auto together = pipe_run({.kind = kind, .threads = 2}, core::Communicator::world());
        CHECK_MESSAGE(differences(*together, *alone) == 0, kind);
    }
}

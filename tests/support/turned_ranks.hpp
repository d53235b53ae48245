// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A sector of a ring on several ranks beside the same on one.
#include "tests/support/turned_grids.hpp"

namespace test {

inline std::unique_ptr<FluidRun> sector_run(physics::AdvectionScheme scheme, const tasks::ExecutorOptions& executor,
                                            const core::Communicator& ranks)
{
    const Carried carried{.turbulence = physics::TurbulenceParameters{physics::turbulence_of(1.0, 0.1, 0.05), {}, 0.0}};
    auto run = std::make_unique<FluidRun>(ring_sector({4, 8, 8}, {1, 2, 2}), between_cylinders(0.1, scheme), executor, ranks, carried);
    run->start(wavy_swirl);
    for (int n = 0; n < 4; ++n) run->step(0.02);
    return run;
}

/// Cells of this rank where any bit of velocity, pressure or turbulence differs from `whole`.
inline int different_bits(FluidRun& part, FluidRun& whole)
{
    int count = 0;
    for (core::LocalBlock b = 0; b < part.mesh().own_count(); ++b) {
        const core::LocalBlock other = whole.mesh().local(part.mesh().global(b));
        core::for_each_cell(part.mesh().geometry(b).cells, [&](int i, int j, int k) {
            count += part.velocity(b, i, j, k) != whole.velocity(other, i, j, k) ||
                     part.fluid().state().pressure.on(b)(i, j, k) != whole.fluid().state().pressure.on(other)(i, j, k) ||
                     part.turbulence().k().on(b)(i, j, k) != whole.turbulence().k().on(other)(i, j, k);
        });
    }
    return count;
}

} // namespace test

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=3 timeout=300
// Blocks of a sector whose ends are joined by a turn, shared between three ranks.
#include "tests/support/turned_ranks.hpp"
#include <doctest/doctest.h>

TEST_CASE("three ranks and one have the same bits of a sector, whoever executes")
{
    for (const auto scheme : {physics::AdvectionScheme::lcsi, physics::AdvectionScheme::finite_volume}) {
        const auto alone = test::sector_run(scheme, {.kind = "serial"}, core::Communicator::self());
        for (const char* kind : {"serial", "shuffle:3", "tbb", "openmp"}) {
            const auto together = test::sector_run(scheme, {.kind = kind, .threads = 2}, core::Communicator::world());
            CHECK_MESSAGE(test::different_bits(*together, *alone) == 0, kind);
        }
    }
}

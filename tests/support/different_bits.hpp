// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far two coupled runs are from having the same bits.
#include "tests/support/coupled_run.hpp"
#include <map>

namespace test {

/// Places and velocities of grains, and velocities of the fluid in cells, that this rank has in `shared` and that differ in `alone`.
/// @param alone  The same scene on one rank.
inline int different_bits(CoupledRun& shared, CoupledRun& alone)
{
    std::map<std::int64_t, int> row;
    for (int g = 0; g < alone.grains().owned; ++g) row[alone.grains().id[std::size_t(g)]] = g;
    int different = 0;
    for (int g = 0; g < shared.grains().owned; ++g) {
        const int other = row.at(shared.grains().id[std::size_t(g)]);
        different += (shared.grains().velocity_of(g) - alone.grains().velocity_of(other)).norm() != 0;
        different += (shared.grains().position_of(g) - alone.grains().position_of(other)).norm() != 0;
    }
    const core::Mesh &mine = shared.world().mesh(), &all = alone.world().mesh();
    for (core::LocalBlock b = 0; b < mine.own_count(); ++b) {
        const auto u = shared.world().fluid()->state().velocity.on(b),
                   v = alone.world().fluid()->state().velocity.on(all.local(mine.global(b)));
        core::for_each_cell(mine.geometry(b).cells, [&](int i, int j, int k) {
            for (int c = 0; c < 3; ++c) different += u.component(c)(i, j, k) != v.component(c)(i, j, k);
        });
    }
    return different;
}

} // namespace test

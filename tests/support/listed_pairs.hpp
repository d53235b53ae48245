// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pairs that a set of particles without a past lists.
#include "core/particles/pair_list.hpp"

namespace test {

/// All pairs with a gap below `skin` [m].
inline core::PairList listed_pairs(const core::ParticleSet& set, const core::LevelBins& bins, double skin)
{
    core::CellLists cells;
    cells.build(set, bins);
    core::PairList pairs;
    pairs.build(set, cells, skin, core::SerialTeam{});
    return pairs;
}

} // namespace test

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where copies of particles are kept from when pairs first read them until the pairs of their own chunk have.
#include "core/particles/pair_slots.hpp"

namespace core {

/// As the pairs of chunks run one after the other, what they read moves on through the particles like a window: few are copied at a time,
/// and copies are still in the cache when they are read. Each segment has a window of its own; ghosts have places that all see.
struct ChunkWindows {
    std::vector<std::vector<int>> offset; ///< Of each segment and chunk: a particle's copy is at its place in the set and this.
    std::vector<std::vector<int>> enter;  ///< For each chunk: the chunks that its segment must copy before its pairs run.
    int first_ghost = 0;                  ///< The first particle of the first chunk that has ghosts alone; their copies begin at 0.
    int count = 0;                        ///< Copies in all.

    void plan(const PairList& pairs, const ChunkPlan& chunks, int owned, int ghosts);
};

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the forces of pairs are kept from when they are found to when they are summed.
#include "core/particles/pair_list.hpp"

#include <span>

namespace core {

/// Chunks of particles that run one after the other. A deferred chunk is moved only when the pairs of all chunks are done.
struct ChunkPlan {
    std::vector<int> segments;  ///< Chunks [segments[s], segments[s + 1]) run one after the other, segments beside each other.
    std::vector<char> deferred; ///< One for each chunk.
};

/// Results of a chunk's pairs are read by the chunk itself and by those that its pairs touch. When the last of them has moved, their
/// slots serve later chunks: what is written is still in the cache when it is read, and takes little memory.
struct PairSlots {
    std::vector<int> offset; ///< Of each chunk: the slot of a pair is its place in the pair list and this.
    int count = 0;           ///< Slots in all.

    void plan(const PairList& pairs, const ChunkPlan& chunks);
    /// Slots of their own for all pairs, which last until the next step.
    void keep_all(const PairList& pairs);
};

} // namespace core

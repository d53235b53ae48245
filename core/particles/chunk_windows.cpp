// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/chunk_windows.hpp"

namespace core {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }
constexpr int nowhere = -1;

/// The place of a chunk's copies: one that is free, or a new one behind all others.
int take(std::vector<int>& free, int& top)
{
    if (free.empty()) {
        top += particles_per_chunk;
        return top - particles_per_chunk;
    }
    const int place = free.back();
    free.pop_back();
    return place;
}

} // namespace

void ChunkWindows::plan(const PairList& pairs, const ChunkPlan& chunks, int owned, int ghosts)
{
    const int moving = pairs.chunks(), all = (owned + ghosts + particles_per_chunk - 1) / particles_per_chunk;
    const bool last_has_ghosts = owned % particles_per_chunk != 0 && ghosts > 0; // which no link tells of
    first_ghost = moving * particles_per_chunk;
    count = (all - moving) * particles_per_chunk;
    enter.assign(index_of(moving), {});
    offset.assign(chunks.segments.size() - 1, std::vector<int>(index_of(all), -first_ghost));
    for (std::size_t s = 0; s < offset.size(); ++s) {
        std::vector<int> place(index_of(moving), nowhere), free;
        for (int c = chunks.segments[s]; c < chunks.segments[s + 1]; ++c) {
            const auto copy = [&](int chunk) {
                if (place[index_of(chunk)] != nowhere) return;
                place[index_of(chunk)] = take(free, count);
                offset[s][index_of(chunk)] = place[index_of(chunk)] - chunk * particles_per_chunk;
                enter[index_of(c)].push_back(chunk);
            };
            copy(c);
            for (const int later : pairs.links[index_of(c)]) copy(later);
            if (last_has_ghosts) copy(moving - 1);
            free.push_back(place[index_of(c)]);
        }
    }
}

} // namespace core

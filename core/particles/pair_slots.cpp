// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/pair_slots.hpp"

#include <algorithm>

namespace core {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

struct Range {
    int begin, end;
};

/// Takes the first range that is long enough from those that are free, or new slots behind all others.
int take(std::vector<Range>& free, int length, int& top)
{
    for (Range& range : free) {
        if (range.end - range.begin < length) continue;
        range.begin += length;
        return range.begin - length;
    }
    top += length;
    return top - length;
}

/// Ranges stay in order; those that touch become one.
void give_back(std::vector<Range>& free, Range range)
{
    const auto next = std::find_if(free.begin(), free.end(), [&](const Range& r) { return r.begin >= range.end; });
    free.insert(next, range);
    std::vector<Range> joined;
    for (const Range& r : free) {
        if (r.begin == r.end) continue;
        if (!joined.empty() && joined.back().end == r.begin) joined.back().end = r.end;
        else joined.push_back(r);
    }
    free.swap(joined);
}

} // namespace

void PairSlots::plan(const PairList& pairs, const ChunkPlan& chunks)
{
    offset.assign(index_of(pairs.chunks()), 0);
    count = 0;
    const auto begin = [&](int c) { return pairs.chunk_begin[index_of(c)]; };
    std::vector<std::vector<Range>> until(index_of(pairs.chunks())); // what is free once a chunk has moved
    for (std::size_t s = 0; s + 1 < chunks.segments.size(); ++s) {
        std::vector<Range> free;
        for (int c = chunks.segments[s]; c < chunks.segments[s + 1]; ++c) {
            const int length = begin(c + 1) - begin(c), slot = take(free, length, count);
            offset[index_of(c)] = slot - begin(c);
            const auto& readers = pairs.links[index_of(c)]; // in order
            const int last = readers.empty() ? c : readers.back();
            const bool waits = chunks.deferred[index_of(c)] != 0 || last >= chunks.segments[s + 1] ||
                               std::any_of(readers.begin(), readers.end(), [&](int r) { return chunks.deferred[index_of(r)] != 0; });
            if (!waits && length > 0) until[index_of(last)].push_back({slot, slot + length});
            for (const Range& range : until[index_of(c)]) give_back(free, range);
        }
    }
}

void PairSlots::keep_all(const PairList& pairs)
{
    offset.assign(index_of(pairs.chunks()), 0);
    count = pairs.size();
}

} // namespace core

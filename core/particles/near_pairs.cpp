// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

static_assert(particles_per_chunk <= 256, "NearPairs::order has bytes");

/// Pairs of `chunk` that are near. The test has no branch: whether a pair is near cannot be foreseen.
std::vector<int> near_in(const NearPairs::Choice& from, int chunk)
{
    const PairList& pairs = from.pairs;
    const int begin = pairs.chunk_begin[index_of(chunk)], end = pairs.chunk_begin[index_of(chunk) + 1];
    const double *x = from.particles.position[0].data(), *y = from.particles.position[1].data(), *z = from.particles.position[2].data();
    const double* radius = from.particles.radius.data();
    std::vector<int> near(index_of(end - begin));
    std::size_t count = 0;
    for (int p = begin; p < end; ++p) {
        const auto i = index_of(pairs.first[index_of(p)]), j = index_of(pairs.second[index_of(p)]);
        const Vec3& shift = from.shifts[pairs.image[index_of(p)]];
        const double dx = x[j] - x[i] + shift[0], dy = y[j] - y[i] + shift[1], dz = z[j] - z[i] + shift[2];
        const double reach = radius[i] + radius[j] + from.skin;
        near[count] = p;
        count += std::size_t(dx * dx + dy * dy + dz * dz < reach * reach);
    }
    near.resize(count);
    return near;
}

/// The spring of pair p before its first choice. Both have it if both are owned; a large particle has a long row.
Spring spring_before(const ParticleSet& particles, const PairList& pairs, std::size_t p, const ContactHistory& history)
{
    const int low = std::min(pairs.first[p], pairs.second[p]), high = std::max(pairs.first[p], pairs.second[p]);
    const bool turn = high < particles.owned && history.row_size(high) < history.row_size(low);
    return turn ? history.find(high, particles.id[index_of(low)]) : history.find(low, particles.id[index_of(high)]);
}

} // namespace

void NearPairs::select(const Choice& from, const ContactHistory* history, int chunk)
{
    const PairList& pairs = from.pairs;
    const int begin = pairs.chunk_begin[index_of(chunk)], end = pairs.chunk_begin[index_of(chunk) + 1];
    auto& chunk_runs = runs[index_of(chunk)];
    const int before = history || chunk_runs.empty() ? begin : chunk_runs.back().end;
    std::vector<Column> old; // springs of the near pairs of before
    for (const auto& column : spring) old.emplace_back(column.begin() + begin, column.begin() + before);

    const std::vector<int> near = near_in(from, chunk);
    const auto key_of = [&](std::size_t p) {
        const auto i = index_of(pairs.first[p]), j = index_of(pairs.second[p]);
        const int species = from.particles.species[i] * species_count + from.particles.species[j];
        return index_of(2 * kinds[index_of(species)] + int(pairs.image[p] != no_shift));
    };
    std::vector<int> next(index_of(2 * kind_count + 1), 0);
    for (const int p : near) ++next[key_of(index_of(p)) + 1];
    chunk_runs.clear();
    next[0] = begin;
    for (std::size_t key = 0; key + 1 < next.size(); ++key) {
        next[key + 1] += next[key];
        if (next[key + 1] > next[key]) chunk_runs.push_back({next[key], next[key + 1], int(key / 2), key % 2 == 1});
    }
    const auto take = [&](std::size_t p) {
        const auto m = index_of(next[key_of(p)]++);
        const Spring kept = history ? spring_before(from.particles, pairs, p, *history) : Spring{};
        const int place = history || slot_[p] < 0 ? -1 : slot_[p] - offset_[index_of(chunk)] - begin;
        for (std::size_t a = 0; a < spring.size(); ++a) spring[a][m] = place >= 0 ? old[a][index_of(place)] : kept[a];
        first[m] = pairs.first[p];
        second[m] = pairs.second[p];
        pair[m] = int(p);
    };
    for (const int p : near) take(index_of(p));
    const int offset = from.slots.offset[index_of(chunk)];
    std::fill(slot_.begin() + begin, slot_.begin() + end, -1);
    if (!chunk_runs.empty())
        for (int m = begin; m < chunk_runs.back().end; ++m) slot_[index_of(pair[index_of(m)])] = m + offset;
}

void NearPairs::sort_by_length(const PairList& pairs, int begin, int end)
{
    constexpr int longest = 24;
    const auto length = [&](int i) { return index_of(std::min(row_end[index_of(i)] - pairs.row_begin[index_of(i)], longest)); };
    std::array<int, longest + 2> next{};
    for (int i = begin; i < end; ++i) ++next[length(i) + 1];
    next[0] = begin;
    for (std::size_t n = 1; n < next.size(); ++n) next[n] += next[n - 1];
    for (int i = begin; i < end; ++i) order[index_of(next[length(i)]++)] = std::uint8_t(i - begin);
}

void NearPairs::start(const Choice& choice, const ContactHistory& history, const Team& team)
{
    const auto total = index_of(choice.pairs.size());
    for (auto* list : {&first, &second, &pair, &slot_}) list->resize(total);
    spring.resize(index_of(history.width));
    for (auto& column : spring) column.resize(total);
    runs.resize(index_of(choice.pairs.chunks()));
    row.resize(choice.pairs.row.size());
    row_end.resize(index_of(choice.particles.owned));
    order.resize(index_of(choice.particles.owned));
    choose(choice, &history, team);
}

void NearPairs::refresh(const Choice& choice, const Team& team) { choose(choice, nullptr, team); }

void NearPairs::choose(const Choice& from, const ContactHistory* history, const Team& team)
{
    const PairList& pairs = from.pairs;
    team.run(pairs.chunks(), [&](int c) { select(from, history, c); });
    for_chunks(team, from.particles.owned, particles_per_chunk, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            int next = pairs.row_begin[index_of(i)];
            for (int k = next; k < pairs.row_begin[index_of(i) + 1]; ++k) {
                const int entry = pairs.row[index_of(k)], slot = slot_[index_of(entry / 2)];
                row[index_of(next)] = 2 * slot + entry % 2;
                next += int(slot >= 0);
            }
            row_end[index_of(i)] = next;
        }
        sort_by_length(pairs, begin, end);
    });
    offset_ = from.slots.offset;
}

int NearPairs::near_of(const PairList& pairs, std::size_t p) const
{
    const int chunk = std::min(pairs.first[p], pairs.second[p]) / particles_per_chunk;
    return slot_[p] < 0 ? -1 : slot_[p] - offset_[index_of(chunk)];
}

void NearPairs::append_row(const ParticleSet& particles, const PairList& pairs, int i, ContactHistory& history) const
{
    for (int k = pairs.row_begin[index_of(i)]; k < pairs.row_begin[index_of(i) + 1]; ++k) {
        const int entry = pairs.row[index_of(k)], m = near_of(pairs, index_of(entry / 2));
        if (m < 0) continue;
        Spring value{};
        for (std::size_t a = 0; a < spring.size(); ++a) value[a] = spring[a][index_of(m)];
        if (value == Spring{}) continue;
        history.add(particles.id[index_of(entry % 2 == 0 ? second[index_of(m)] : first[index_of(m)])], value);
    }
}

} // namespace core

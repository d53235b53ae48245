// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/near_pairs.hpp"
#include "core/base/renew.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

static_assert(particles_per_chunk <= 256, "NearPairs::order has bytes");

/// For each pair of `chunk` whether it is near. The test has no branch: whether a pair is near cannot be foreseen.
std::vector<std::uint8_t> near_in(const NearPairs::Choice& from, int chunk)
{
    const PairList& pairs = from.pairs;
    const int begin = pairs.chunk_begin[index_of(chunk)], end = pairs.chunk_begin[index_of(chunk) + 1];
    const double *x = from.particles.position[0].data(), *y = from.particles.position[1].data(), *z = from.particles.position[2].data();
    const double* radius = from.particles.radius.data();
    std::vector<std::uint8_t> near(index_of(end - begin));
    for (int p = begin; p < end; ++p) {
        const auto i = index_of(pairs.first[index_of(p)]), j = index_of(pairs.second[index_of(p)]);
        const Vec3& shift = from.shifts[pairs.image[index_of(p)]];
        const double dx = x[j] - x[i] + shift[0], dy = y[j] - y[i] + shift[1], dz = z[j] - z[i] + shift[2];
        const double reach = radius[i] + radius[j] + from.skin;
        near[index_of(p - begin)] = std::uint8_t(dx * dx + dy * dy + dz * dz < reach * reach);
    }
    return near;
}

/// Value n of a chunk goes to place to[n].
template <class T>
void permute(std::vector<T>& values, int begin, const std::vector<int>& to)
{
    const std::vector<T> old(values.begin() + begin, values.begin() + begin + std::ptrdiff_t(to.size()));
    for (std::size_t n = 0; n < to.size(); ++n) values[index_of(begin + to[n])] = old[n];
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
    PairList& pairs = from.pairs;
    const int begin = pairs.chunk_begin[index_of(chunk)], before = history ? 0 : count(chunk);
    const std::vector<std::uint8_t> near = near_in(from, chunk);
    const auto far = index_of(2 * kind_count);
    const auto key_of = [&](std::size_t n) {
        const auto p = index_of(begin) + n;
        const int species =
            from.particles.species[index_of(pairs.first[p])] * species_count + from.particles.species[index_of(pairs.second[p])];
        return near[n] != 0 ? index_of(2 * kinds[index_of(species)] + int(pairs.image[p] != no_shift)) : far;
    };
    std::vector<int> next(far + 2, 0), to(near.size());
    for (std::size_t n = 0; n < near.size(); ++n) ++next[key_of(n) + 1];
    auto& chunk_runs = runs[index_of(chunk)];
    chunk_runs.clear();
    for (std::size_t key = 0; key < far; ++key) {
        next[key + 1] += next[key];
        if (next[key + 1] > next[key]) chunk_runs.push_back({begin + next[key], begin + next[key + 1], int(key / 2), key % 2 == 1});
    }
    const auto now = index_of(next[far]);
    Column springs(index_of(width_) * now);
    const Column& old = spring[index_of(chunk)];
    for (std::size_t n = 0; n < near.size(); ++n) {
        to[n] = next[key_of(n)]++;
        if (near[n] == 0 || (!history && n >= index_of(before))) continue;
        const Spring kept = history ? spring_before(from.particles, pairs, index_of(begin) + n, *history) : Spring{};
        for (std::size_t a = 0; a < index_of(width_); ++a)
            springs[a * now + index_of(to[n])] = history ? kept[a] : old[a * index_of(before) + n];
    }
    spring[index_of(chunk)] = std::move(springs);
    permute(pairs.first, begin, to);
    permute(pairs.second, begin, to);
    permute(pairs.image, begin, to);
    permute(pairs.places, begin, to);
    list_chunk(pairs, chunk, from.slots.offset[index_of(chunk)]);
}

/// Writes the pairs of a chunk to the rows of their particles: where a pair is near, its place and `offset`, else nothing.
void NearPairs::list_chunk(const PairList& pairs, int chunk, int offset)
{
    const int begin = pairs.chunk_begin[index_of(chunk)], end = begin + count(chunk);
    for (int p = begin; p < pairs.chunk_begin[index_of(chunk) + 1]; ++p)
        for (const int side : {0, 1})
            if (const int place = pairs.places[index_of(p)][index_of(side)]; place >= 0)
                row[index_of(place)] = p < end ? 2 * (p + offset) + side : -1;
}

/// Brings what the rows of particles [begin, end) have to their beginnings.
void NearPairs::close_rows(const PairList& pairs, int begin, int end)
{
    for (int i = begin; i < end; ++i) {
        int next = pairs.row_begin[index_of(i)];
        for (int k = next; k < pairs.row_begin[index_of(i) + 1]; ++k) {
            const int entry = row[index_of(k)];
            row[index_of(next)] = entry;
            next += int(entry >= 0);
        }
        row_end[index_of(i)] = next;
    }
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
    width_ = history.width;
    spring.resize(index_of(choice.pairs.chunks()));
    runs.resize(index_of(choice.pairs.chunks()));
    renew(row, index_of(choice.pairs.row_begin.back()));
    renew(row_end, index_of(choice.particles.owned));
    renew(order, index_of(choice.particles.owned));
    choose(choice, &history, team);
}

void NearPairs::refresh(const Choice& choice, const Team& team) { choose(choice, nullptr, team); }

void NearPairs::choose(const Choice& from, const ContactHistory* history, const Team& team)
{
    team.run(from.pairs.chunks(), [&](int c) { select(from, history, c); });
    for_chunks(team, from.particles.owned, particles_per_chunk, [&](int begin, int end) {
        close_rows(from.pairs, begin, end);
        sort_by_length(from.pairs, begin, end);
    });
}

void NearPairs::list_pairs(const PairList& pairs, const Team& team)
{
    team.run(pairs.chunks(), [&](int c) { list_chunk(pairs, c, 0); });
    for_chunks(team, int(row_end.size()), particles_per_chunk, [&](int begin, int end) { close_rows(pairs, begin, end); });
}

void NearPairs::append_row(const ParticleSet& particles, const PairList& pairs, int i, ContactHistory& history) const
{
    for (int k = pairs.row_begin[index_of(i)]; k < row_end[index_of(i)]; ++k) {
        const int entry = row[index_of(k)];
        const auto p = index_of(entry / 2);
        const int chunk = std::min(pairs.first[p], pairs.second[p]) / particles_per_chunk;
        const auto near = index_of(count(chunk)), m = p - index_of(pairs.chunk_begin[index_of(chunk)]);
        Spring value{};
        for (std::size_t a = 0; a < index_of(width_); ++a) value[a] = spring[index_of(chunk)][a * near + m];
        if (value != Spring{}) history.add(particles.id[index_of(entry % 2 == 0 ? pairs.second[p] : pairs.first[p])], value);
    }
}

void NearPairs::release()
{
    spring.clear();
    for (auto& chunk_runs : runs) chunk_runs.clear();
}

} // namespace core

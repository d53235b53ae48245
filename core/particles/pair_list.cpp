// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/pair_list.hpp"
#include "core/base/renew.hpp"

#include <algorithm>

namespace core {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

/// The ways to the images of a lattice [m].
std::array<std::array<float, 3>, 27> shifts_of(const BinLattice& lattice)
{
    std::array<std::array<float, 3>, 27> shifts;
    for (int n = 0; n < 27; ++n)
        for (std::size_t a = 0; a < 3; ++a) {
            const int step = a == 0 ? n % 3 - 1 : a == 1 ? n / 3 % 3 - 1 : n / 9 - 1;
            shifts[index_of(n)][a] = float(step * lattice.width[int(a)] * double(lattice.count[a]));
        }
    return shifts;
}

} // namespace

/// Among particles of its own size a particle looks for those that come after it; among larger ones for all, who then need not look for
/// it. Ghosts look for larger owned ones only.
void PairList::find(Search& search, int chunk)
{
    const ParticleSet& particles = search.particles;
    const CellLists& cells = search.cells;
    auto& crossing = search.crossing[index_of(chunk)];
    std::array<CellRow, 27> rows;
    const int begin = chunk * particles_per_chunk, end = std::min(particles.size(), begin + particles_per_chunk);
    const SizeLevels& sizes = cells.sizes();
    for (int level = 0; level < sizes.count(); ++level) {
        const CellList& list = cells.at(level);
        const BinLattice& lattice = list.lattice();
        const auto shifts = shifts_of(lattice);
        for (int i = begin; i < end; ++i) {
            const int own = sizes.level_of(particles.radius[index_of(i)]);
            if (own < level || (i >= particles.owned && own == level)) continue;
            const int before = own == level ? i : -1, after = i < particles.owned ? particles.size() : particles.owned;
            const Vec3 position = particles.position_of(i), here = position - lattice.low;
            const float reach = float(particles.radius[index_of(i)] + search.skin) + list.rounding();
            const int count = list.rows_around(lattice.bin(position), rows);
            for (int r = 0; r < count; ++r) {
                const auto& [first_entry, stop, image] = rows[index_of(r)];
                const auto& shift = shifts[index_of(image)];
                const float x = float(here[0]) - shift[0], y = float(here[1]) - shift[1], z = float(here[2]) - shift[2];
                for (auto k = index_of(first_entry); k < index_of(stop); ++k) {
                    const int j = list.index[k];
                    if (j <= before || j >= after) continue;
                    const float dx = list.x[k] - x, dy = list.y[k] - y, dz = list.z[k] - z;
                    const float near = list.radius[k] + reach;
                    if (dx * dx + dy * dy + dz * dz > near * near) continue;
                    auto& found = std::min(i, j) >= begin && i < particles.owned ? search.found[index_of(chunk)] : crossing;
                    if (particles.id[index_of(i)] < particles.id[index_of(j)]) found.push_back({i, j, std::uint8_t(image)});
                    else found.push_back({j, i, std::uint8_t(26 - image)});
                }
            }
        }
    }
}

void PairList::hand_over_crossing(Search& search)
{
    for (const auto& crossing : search.crossing)
        for (const Found& pair : crossing) search.found[index_of(std::min(pair.first, pair.second) / particles_per_chunk)].push_back(pair);
}

void PairList::copy_chunk(Search& search, int chunk)
{
    auto p = index_of(chunk_begin[index_of(chunk)]);
    auto& later = links[index_of(chunk)];
    later.clear();
    auto& found = search.found[index_of(chunk)];
    for (const auto& pair : found) {
        first[p] = pair.first;
        second[p] = pair.second;
        image[p] = pair.image;
        places[p] = {-1, -1};
        const int high = std::max(pair.first, pair.second);
        const int other = high / particles_per_chunk;
        if (high < search.particles.owned && other != chunk && (later.empty() || later.back() != other)) later.push_back(other);
        ++p;
    }
    found = {};
    std::sort(later.begin(), later.end());
    later.erase(std::unique(later.begin(), later.end()), later.end());
}

void PairList::build(const ParticleSet& particles, const CellLists& cells, double skin, const Team& team)
{
    const int count = (particles.owned + particles_per_chunk - 1) / particles_per_chunk;
    const bool levels = cells.sizes().count() > 1;
    const int looking = levels ? (particles.size() + particles_per_chunk - 1) / particles_per_chunk : count;
    Search search{particles, cells, skin};
    search.found.resize(index_of(count));
    search.crossing.resize(index_of(looking));
    links.resize(index_of(count));
    team.run(looking, [&](int c) { find(search, c); });
    if (levels) hand_over_crossing(search);
    chunk_begin.assign(1, 0);
    for (int c = 0; c < count; ++c) chunk_begin.push_back(chunk_begin.back() + int(search.found[index_of(c)].size()));
    const auto total = index_of(chunk_begin.back());
    renew(first, total);
    renew(second, total);
    renew(image, total);
    renew(places, total);
    team.run(count, [&](int c) { copy_chunk(search, c); });
    build_rows(particles, team);
}

/// Calls act(pair, side, particle) for the owned particles of chunks [begin, end) in all their pairs.
template <class Act>
void PairList::for_each_end(int owned, int begin, int end, Act act) const
{
    const int low = begin * particles_per_chunk, high = std::min(owned, end * particles_per_chunk);
    for (int c = 0; c < end; ++c) {
        const auto& later = links[index_of(c)];
        const auto link = std::lower_bound(later.begin(), later.end(), begin);
        if (c < begin && (link == later.end() || *link >= end)) continue;
        for (auto p = index_of(chunk_begin[index_of(c)]); p < index_of(chunk_begin[index_of(c) + 1]); ++p)
            for (const int side : {0, 1})
                if (const int i = side == 0 ? first[p] : second[p]; i >= low && i < high) act(p, side, i);
    }
}

/// Each thread makes the rows of consecutive chunks.
void PairList::build_rows(const ParticleSet& particles, const Team& team)
{
    const int owned = particles.owned, parts = team.threads();
    const auto begin_of = [&](int part) { return int(std::int64_t(chunks()) * part / parts); };
    row_begin.assign(index_of(owned) + 1, 0);
    team.run(parts, [&](int part) {
        for_each_end(owned, begin_of(part), begin_of(part + 1), [&](std::size_t, int, int i) { ++row_begin[index_of(i) + 1]; });
    });
    for (int i = 0; i < owned; ++i) row_begin[index_of(i) + 1] += row_begin[index_of(i)];
    std::vector<int> row(index_of(row_begin.back())), next(row_begin.begin(), row_begin.end() - 1); // 2 pair + side
    const auto other_id = [&](int end) {
        const auto p = index_of(end / 2);
        return particles.id[index_of(end % 2 == 0 ? second[p] : first[p])];
    };
    team.run(parts, [&](int part) {
        const int begin = begin_of(part), end = begin_of(part + 1);
        for_each_end(owned, begin, end, [&](std::size_t p, int side, int i) { row[index_of(next[index_of(i)]++)] = 2 * int(p) + side; });
        for (int i = begin * particles_per_chunk; i < std::min(owned, end * particles_per_chunk); ++i) {
            const int first_place = row_begin[index_of(i)], stop = row_begin[index_of(i) + 1];
            std::sort(row.begin() + first_place, row.begin() + stop, [&](int a, int b) { return other_id(a) < other_id(b); });
            for (int k = first_place; k < stop; ++k) places[index_of(row[index_of(k)] / 2)][index_of(row[index_of(k)] % 2)] = k;
        }
    });
}

} // namespace core

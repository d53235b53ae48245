// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/pair_list.hpp"

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
void PairList::find(const ParticleSet& particles, const CellLists& cells, double skin, int chunk)
{
    auto& crossing = crossing_[index_of(chunk)];
    crossing.clear();
    std::array<CellRow, 27> rows;
    const int begin = chunk * particles_per_chunk, end = std::min(particles.size(), begin + particles_per_chunk);
    if (begin < particles.owned) found_[index_of(chunk)].clear();
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
            const float reach = float(particles.radius[index_of(i)] + skin) + list.rounding();
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
                    auto& found = std::min(i, j) >= begin && i < particles.owned ? found_[index_of(chunk)] : crossing;
                    if (particles.id[index_of(i)] < particles.id[index_of(j)]) found.push_back({i, j, std::uint8_t(image)});
                    else found.push_back({j, i, std::uint8_t(26 - image)});
                }
            }
        }
    }
}

void PairList::hand_over_crossing()
{
    for (const auto& crossing : crossing_)
        for (const Found& pair : crossing) found_[index_of(std::min(pair.first, pair.second) / particles_per_chunk)].push_back(pair);
}

void PairList::copy_chunk(const ParticleSet& particles, int chunk)
{
    auto p = index_of(chunk_begin[index_of(chunk)]);
    auto& later = links[index_of(chunk)];
    later.clear();
    for (const auto& pair : found_[index_of(chunk)]) {
        first[p] = pair.first;
        second[p] = pair.second;
        image[p] = pair.image;
        const int high = std::max(pair.first, pair.second);
        const int other = high / particles_per_chunk;
        if (high < particles.owned && other != chunk && (later.empty() || later.back() != other)) later.push_back(other);
        ++p;
    }
    std::sort(later.begin(), later.end());
    later.erase(std::unique(later.begin(), later.end()), later.end());
}

void PairList::build(const ParticleSet& particles, const CellLists& cells, double skin, const Team& team)
{
    const int count = (particles.owned + particles_per_chunk - 1) / particles_per_chunk;
    found_.resize(index_of(count));
    links.resize(index_of(count));
    const bool levels = cells.sizes().count() > 1;
    const int looking = levels ? (particles.size() + particles_per_chunk - 1) / particles_per_chunk : count;
    crossing_.resize(index_of(looking));
    team.run(looking, [&](int c) { find(particles, cells, skin, c); });
    if (levels) hand_over_crossing();
    chunk_begin.assign(1, 0);
    for (int c = 0; c < count; ++c) chunk_begin.push_back(chunk_begin.back() + int(found_[index_of(c)].size()));
    const auto total = index_of(chunk_begin.back());
    first.resize(total);
    second.resize(total);
    image.resize(total);
    team.run(count, [&](int c) { copy_chunk(particles, c); });
    build_rows(particles, team);
}

void PairList::build_rows(const ParticleSet& particles, const Team& team)
{
    const int owned = particles.owned;
    row_begin.assign(index_of(owned) + 1, 0);
    for (std::size_t p = 0; p < first.size(); ++p) {
        if (first[p] < owned) ++row_begin[index_of(first[p]) + 1];
        if (second[p] < owned) ++row_begin[index_of(second[p]) + 1];
    }
    for (int i = 0; i < owned; ++i) row_begin[index_of(i) + 1] += row_begin[index_of(i)];
    std::vector<int> next(row_begin.begin(), row_begin.end() - 1);
    row.resize(index_of(row_begin.back()));
    for (std::size_t p = 0; p < first.size(); ++p) {
        if (first[p] < owned) row[index_of(next[index_of(first[p])]++)] = 2 * int(p);
        if (second[p] < owned) row[index_of(next[index_of(second[p])]++)] = 2 * int(p) + 1;
    }
    const auto other_id = [&](int entry) {
        const auto p = index_of(entry / 2);
        return particles.id[index_of(entry % 2 == 0 ? second[p] : first[p])];
    };
    for_chunks(team, owned, particles_per_chunk, [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            std::sort(row.begin() + row_begin[index_of(i)], row.begin() + row_begin[index_of(i) + 1],
                      [&](int a, int b) { return other_id(a) < other_id(b); });
    });
}

} // namespace core

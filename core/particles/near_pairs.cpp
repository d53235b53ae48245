// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

} // namespace

void NearPairs::select(const ParticleSet& particles, const PairList& pairs, const std::array<Vec3, 27>& shifts, double skin, int chunk)
{
    const int begin = pairs.chunk_begin[index_of(chunk)], end = pairs.chunk_begin[index_of(chunk) + 1];
    auto m = index_of(begin);
    const auto& x = particles.position;
    const auto take = [&](std::size_t p, const Vec3& shift) {
        const auto i = index_of(pairs.first[p]), j = index_of(pairs.second[p]);
        const double dx = x[0][j] - x[0][i] + shift[0], dy = x[1][j] - x[1][i] + shift[1], dz = x[2][j] - x[2][i] + shift[2];
        const double reach = particles.radius[i] + particles.radius[j] + skin;
        const bool near = dx * dx + dy * dy + dz * dz < reach * reach;
        place_[p] = near ? int(m) : -1;
        if (!near) return;
        const double mi = particles.mass[i], mj = particles.mass[j];
        first[m] = int(i);
        second[m] = int(j);
        pair[m] = int(p);
        image[m] = pairs.image[p];
        for (std::size_t a = 0; a < spring.size(); ++a) spring[a][m] = pairs.spring[a][p];
        root_mass[m] = std::sqrt(mi * mj / (mi + mj));
        kind[m] = std::uint16_t(particles.species[i] + species_count * particles.species[j]);
        ++m;
    };
    bool any_shifted = false;
    const Vec3 none = Vec3::Zero();
    for (auto p = index_of(begin); p < index_of(end); ++p) {
        if (pairs.image[p] == no_shift) take(p, none);
        else any_shifted = true;
    }
    plain_end[index_of(chunk)] = int(m);
    for (auto p = index_of(begin); any_shifted && p < index_of(end); ++p)
        if (pairs.image[p] != no_shift) take(p, shifts[pairs.image[p]]);
    shifted_end[index_of(chunk)] = int(m);
}

void NearPairs::refresh(const ParticleSet& particles, const PairList& pairs, const std::array<Vec3, 27>& shifts, double skin,
                        const Team& team)
{
    const auto total = index_of(pairs.size());
    for (auto* list : {&first, &second, &pair, &place_}) list->resize(total);
    image.resize(total);
    kind.resize(total);
    root_mass.resize(total);
    spring.resize(pairs.spring.size());
    for (auto& column : spring) column.resize(total);
    plain_end.resize(index_of(pairs.chunks()));
    shifted_end.resize(index_of(pairs.chunks()));
    row.resize(pairs.row.size());
    row_end.resize(index_of(particles.owned));
    team.run(pairs.chunks(), [&](int c) { select(particles, pairs, shifts, skin, c); });
    for_chunks(team, particles.owned, particles_per_chunk, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            int next = pairs.row_begin[index_of(i)];
            for (int k = next; k < pairs.row_begin[index_of(i) + 1]; ++k) {
                const int entry = pairs.row[index_of(k)];
                const int m = place_[index_of(entry / 2)];
                if (m >= 0) row[index_of(next++)] = 2 * m + entry % 2;
            }
            row_end[index_of(i)] = next;
        }
    });
}

void NearPairs::return_springs(PairList& pairs, const Team& team) const
{
    team.run(pairs.chunks(), [&](int c) {
        for (auto m = index_of(pairs.chunk_begin[index_of(c)]); m < index_of(shifted_end[index_of(c)]); ++m)
            for (std::size_t a = 0; a < spring.size(); ++a) pairs.spring[a][index_of(pair[m])] = spring[a][m];
    });
}

} // namespace core

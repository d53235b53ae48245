// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The few pairs that may touch within the next sub-steps: a part of the pair list, refreshed without messages.
#include "core/particles/pair_list.hpp"

namespace core {

/// Entry m of every array describes one near pair. The near pairs of chunk c fill the places from pairs.chunk_begin[c]
/// on: first those without image shift, up to plain_end[c], then those with one, up to shifted_end[c].
class NearPairs {
public:
    /// Takes from `pairs` those with a gap below `skin` [m], and their springs.
    void refresh(const ParticleSet& particles, const PairList& pairs, const std::array<Vec3, 27>& shifts, double skin, const Team& team);
    /// Writes the springs back to the pairs; to be called before every refresh and rebuild but the first.
    void return_springs(PairList& pairs, const Team& team) const;

    std::vector<int> first, second, pair;
    std::vector<std::uint8_t> image;
    std::vector<Column> spring;      ///< As PairList::spring.
    Column root_mass;                ///< sqrt(m1 m2 / (m1 + m2)) [kg^1/2].
    std::vector<std::uint16_t> kind; ///< Species of first + species_count * species of second.
    std::vector<int> plain_end, shifted_end;
    std::vector<int> row; ///< As PairList::row with near pairs; row i begins at pairs.row_begin[i].
    std::vector<int> row_end;
    int species_count = 1;

private:
    void select(const ParticleSet& particles, const PairList& pairs, const std::array<Vec3, 27>& shifts, double skin, int chunk);
    std::vector<int> place_; // near pair of each pair, or -1
};

} // namespace core

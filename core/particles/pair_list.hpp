// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pairs of particles that may touch before the next rebuild, each once.
#include "core/base/team.hpp"
#include "core/particles/cell_list.hpp"
#include "core/particles/contact_history.hpp"

namespace core {

/// Particles of one chunk; neither threads nor ranks change it.
inline constexpr int particles_per_chunk = 256;

/// Where a pair stands in the rows of its first and second particle; negative in that of a ghost, which has none.
using PairPlaces = std::array<int, 2>;

/// A pair belongs to the chunk of its particle that comes first in storage, so the pairs of chunks 0..c are all the pairs of
/// the particles in these chunks. Within a chunk they may change their order (NearPairs).
class PairList {
public:
    /// Finds all pairs with at least one owned particle and a gap below `skin` [m].
    void build(const ParticleSet& particles, const CellLists& cells, double skin, const Team& team);

    [[nodiscard]] int size() const { return int(first.size()); }
    [[nodiscard]] int chunks() const { return int(chunk_begin.size()) - 1; }

    std::vector<int> first, second;      ///< Places in the particle set; `first` has the lower id.
    std::vector<std::uint8_t> image;     ///< The image of `second` that `first` meets.
    std::vector<int> chunk_begin{0};     ///< First pair of each chunk of particles, and the end.
    std::vector<int> row_begin{0};       ///< Where the row of each owned particle's pairs begins, and the end; in order of the other's id.
    std::vector<PairPlaces> places;      ///< Of each pair in the rows of its particles.
    std::vector<std::vector<int>> links; ///< For each chunk: the later chunks whose particles its pairs touch.

private:
    struct Found {
        int first, second;
        std::uint8_t image;
    };
    /// While pairs are looked for.
    struct Search {
        const ParticleSet& particles;
        const CellLists& cells;
        double skin;
        std::vector<std::vector<Found>> found{};    ///< Of each chunk of owned particles.
        std::vector<std::vector<Found>> crossing{}; ///< By each chunk of all particles, for the chunk of a larger one that comes before it.
    };
    static void find(Search& search, int chunk);
    static void hand_over_crossing(Search& search);
    void copy_chunk(Search& search, int chunk);
    void build_rows(const ParticleSet& particles, const Team& team);
    template <class Act>
    void for_each_end(int owned, int begin, int end, Act act) const;
};

} // namespace core

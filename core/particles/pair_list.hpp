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

/// A pair belongs to the chunk of its particle that comes first in storage, so the pairs of chunks 0..c are all the pairs of
/// the particles in these chunks.
class PairList {
public:
    /// Finds all pairs with at least one owned particle and a gap below `skin` [m].
    void build(const ParticleSet& particles, const CellLists& cells, double skin, const Team& team);

    [[nodiscard]] int size() const { return int(first.size()); }
    [[nodiscard]] int chunks() const { return int(chunk_begin.size()) - 1; }

    std::vector<int> first, second;      ///< Places in the particle set; `first` has the lower id.
    std::vector<std::uint8_t> image;     ///< The image of `second` that `first` meets.
    std::vector<int> chunk_begin{0};     ///< First pair of each chunk of particles, and the end.
    std::vector<int> row_begin{0};       ///< First entry of each owned particle in `row`, and the end.
    std::vector<int> row;                ///< 2 pair + (0 if the particle is `first`, 1 if `second`), in order of the other's id.
    std::vector<std::vector<int>> links; ///< For each chunk: the later chunks whose particles its pairs touch.

private:
    struct Found {
        int first, second;
        std::uint8_t image;
    };
    void find(const ParticleSet& particles, const CellLists& cells, double skin, int chunk);
    void hand_over_crossing();
    void copy_chunk(const ParticleSet& particles, int chunk);
    void build_rows(const ParticleSet& particles, const Team& team);
    std::vector<std::vector<Found>> found_;    // of each chunk of owned particles
    std::vector<std::vector<Found>> crossing_; // found by each chunk of all particles, for the chunk of a larger one that comes before it
};

} // namespace core

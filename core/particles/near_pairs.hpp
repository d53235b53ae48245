// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The few pairs that may touch within the next sub-steps: a part of the pair list, refreshed without messages.
#include "core/particles/pair_slots.hpp"

namespace core {

/// Near pairs [begin, end) that are alike: those of a run make the same vector code.
struct NearRun {
    int begin, end;
    int kind;     ///< What NearPairs::kinds says of their species.
    bool shifted; ///< Their second particle is met through an image.
};

/// Entry m of every array describes one near pair. The near pairs of chunk c fill the places from pairs.chunk_begin[c] on, run by run.
class NearPairs {
public:
    /// Which pairs are near: those of `pairs` with a gap below `skin` [m].
    struct Choice {
        const ParticleSet& particles;
        const PairList& pairs;
        const std::array<Vec3, 27>& shifts;
        double skin;
        const PairSlots& slots;
    };
    /// Chooses for the first time after PairList::build(). @param history  One row for each owned particle: springs that go on.
    void start(const Choice& choice, const ContactHistory& history, const Team& team);
    /// Chooses again; the springs of pairs that stay near go on.
    void refresh(const Choice& choice, const Team& team);
    /// Appends the springs of owned particle i to the last row of `history`.
    void append_row(const ParticleSet& particles, const PairList& pairs, int i, ContactHistory& history) const;

    /// What makes pairs alike: a number below `kind_count` for the species of first x species_count + that of second.
    std::vector<int> kinds{0};
    int species_count = 1, kind_count = 1;

    std::vector<int> first, second;
    std::vector<int> pair;                  ///< Which of the pair list.
    std::vector<Column> spring;             ///< Springs of `first` against `second`: as many columns as the history is wide.
    std::vector<std::vector<NearRun>> runs; ///< Of each chunk.
    std::vector<int> row;                   ///< As PairList::row with the slots of near pairs; row i begins at pairs.row_begin[i].
    std::vector<int> row_end;
    std::vector<std::uint8_t> order; ///< The particles of each chunk from its first one, those with fewest near pairs first.

private:
    /// The near pair of pair p; negative if it is not near.
    [[nodiscard]] int near_of(const PairList& pairs, std::size_t p) const;
    void choose(const Choice& choice, const ContactHistory* history, const Team& team);
    void select(const Choice& choice, const ContactHistory* history, int chunk);
    void sort_by_length(const PairList& pairs, int begin, int end);
    std::vector<int> slot_;   // of each pair; -1 unless it is near
    std::vector<int> offset_; // of the slots, for each chunk
};

} // namespace core

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

/// The near pairs of a chunk stand before its others in the pair list, run by run.
class NearPairs {
public:
    /// Which pairs are near: those of `pairs` with a gap below `skin` [m].
    struct Choice {
        const ParticleSet& particles;
        PairList& pairs; ///< Its chunks are put in order.
        const std::array<Vec3, 27>& shifts;
        double skin;
        const PairSlots& slots;
    };
    /// Chooses for the first time after PairList::build(). @param history  One row for each owned particle: springs that go on.
    void start(const Choice& choice, const ContactHistory& history, const Team& team);
    /// Chooses again; the springs of pairs that stay near go on.
    void refresh(const Choice& choice, const Team& team);
    /// Appends the springs of owned particle i to the last row of `history`. @pre list_pairs()
    void append_row(const ParticleSet& particles, const PairList& pairs, int i, ContactHistory& history) const;
    /// Fills rows with near pairs instead of their slots.
    void list_pairs(const PairList& pairs, const Team& team);
    /// Forgets all pairs and gives most of their memory back.
    void release();

    /// Pairs of `chunk` that are near.
    [[nodiscard]] int count(int chunk) const
    {
        const auto& of_chunk = runs[std::size_t(chunk)];
        return of_chunk.empty() ? 0 : of_chunk.back().end - of_chunk.front().begin;
    }
    /// Numbers of a spring.
    [[nodiscard]] int width() const { return width_; }

    /// What makes pairs alike: a number below `kind_count` for the species of first x species_count + that of second.
    std::vector<int> kinds{0};
    int species_count = 1, kind_count = 1;

    std::vector<Column> spring;             ///< Of each chunk: springs of `first` against `second`, one column after the other.
    std::vector<std::vector<NearRun>> runs; ///< Of each chunk.
    std::vector<int> row;                   ///< 2 slot + side of a particle's near pairs, from where PairList has its row.
    std::vector<int> row_end;
    std::vector<std::uint8_t> order; ///< The particles of each chunk from its first one, those with fewest near pairs first.

private:
    void choose(const Choice& choice, const ContactHistory* history, const Team& team);
    void select(const Choice& choice, const ContactHistory* history, int chunk);
    void list_chunk(const PairList& pairs, int chunk, int offset);
    void close_rows(const PairList& pairs, int begin, int end);
    void sort_by_length(const PairList& pairs, int begin, int end);
    int width_ = 0; // columns of springs
};

} // namespace core

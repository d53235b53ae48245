// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of a rank sorted by bin, level by level, in single precision: the place where neighbours are looked for.
#include "core/particles/level_bins.hpp"
#include "core/particles/particle_set.hpp"

#include <vector>

namespace core {

/// Consecutive entries of a cell list, seen through one image shift.
struct CellRow {
    int begin = 0, end = 0;
    int image = no_shift;
};

/// Those of one level.
class CellList {
public:
    /// Sorts particles into the bins. @param members  Places in the set, rising.
    void build(const ParticleSet& particles, const BinLattice& lattice, const std::vector<int>& members);
    /// The rows that hold every particle within the cutoff of a particle in bin `home`; returns their number.
    int rows_around(const Bin& home, std::array<CellRow, 27>& rows) const;
    [[nodiscard]] const BinLattice& lattice() const { return lattice_; }
    /// What single precision may add to or take from a distance [m].
    [[nodiscard]] float rounding() const { return rounding_; }

    std::vector<float> x, y, z, radius;
    std::vector<int> index; ///< Place of the entry's particle in the particle set.

private:
    BinLattice lattice_;
    std::vector<int> start_; // first entry of each bin
    float rounding_ = 0.0f;
};

/// All particles, owned and ghosts, each in the list of its level.
class CellLists {
public:
    void build(const ParticleSet& particles, const LevelBins& bins);
    [[nodiscard]] const SizeLevels& sizes() const { return sizes_; }
    /// The list of a level.
    [[nodiscard]] const CellList& at(int level) const { return level_[std::size_t(level)]; }

private:
    SizeLevels sizes_;
    std::vector<CellList> level_;
    std::vector<std::vector<int>> members_;
};

/// The order that sorts the owned particles by bin, and by id within a bin.
[[nodiscard]] std::vector<int> order_by_bin(const ParticleSet& particles, const BinLattice& lattice);

} // namespace core

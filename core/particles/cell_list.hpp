// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// All particles of a rank sorted by bin, in single precision: the place where neighbours are looked for.
#include "core/particles/bin_lattice.hpp"
#include "core/particles/particle_set.hpp"

#include <vector>

namespace core {

/// Consecutive entries of a cell list, seen through one image shift.
struct CellRow {
    int begin = 0, end = 0;
    int image = no_shift;
};

class CellList {
public:
    /// Sorts all particles, owned and ghosts, into the bins.
    void build(const ParticleSet& particles, const BinLattice& lattice);
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

/// The order that sorts the owned particles by bin, and by id within a bin.
[[nodiscard]] std::vector<int> order_by_bin(const ParticleSet& particles, const BinLattice& lattice);

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A lattice of bins for each level of size, the same on all ranks and threads.
#include "core/particles/bin_lattice.hpp"
#include "core/particles/size_levels.hpp"

namespace core {

struct LevelBins {
    SizeLevels sizes;
    std::vector<BinLattice> lattice{BinLattice{}}; ///< Of each level; bins hold the level's largest pair.

    /// The lattice of the smallest spheres.
    [[nodiscard]] const BinLattice& finest() const { return lattice.back(); }
};

/// Lattices for `particles` particles (of all ranks) within `bounds` (of all ranks) whose gaps are of interest below `skin` [m].
/// @throws ConfigError as make_bin_lattice().
[[nodiscard]] LevelBins make_level_bins(const Domain& domain, const Bounds& bounds, const SizeLevels& sizes, double skin,
                                        std::int64_t particles);

} // namespace core

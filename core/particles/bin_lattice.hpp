// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The lattice of bins that sorts particles in space. It is the same on all ranks and threads.
#include "core/particles/domain.hpp"

#include <array>
#include <cstdint>

namespace core {

/// Axis-aligned bounds [m]; empty when low > high.
struct Bounds {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);
};

using Bin = std::array<std::int64_t, 3>;

struct BinLattice {
    Vec3 low = Vec3::Zero();   ///< Corner of bin (0, 0, 0) [m].
    Vec3 width = Vec3::Ones(); ///< At least the cutoff [m].
    Bin count{1, 1, 1};
    std::array<bool, 3> periodic{};
    std::array<int, 3> order{2, 1, 0}; ///< Axes from the slowest (most bins) to the fastest.

    [[nodiscard]] std::int64_t bins() const { return count[0] * count[1] * count[2]; }
    /// Bin along `axis` of coordinate x; positions outside belong to the bins at the rim.
    [[nodiscard]] std::int64_t along(int axis, double x) const;
    [[nodiscard]] Bin bin(const Vec3& x) const { return {along(0, x[0]), along(1, x[1]), along(2, x[2])}; }
    /// Place of a bin in storage order.
    [[nodiscard]] std::int64_t key(const Bin& b) const
    {
        const auto s = std::size_t(order[0]), m = std::size_t(order[1]), f = std::size_t(order[2]);
        return (b[s] * count[m] + b[m]) * count[f] + b[f];
    }
    [[nodiscard]] Bin from_key(std::int64_t key) const;
};

/// The lattice for `particles` particles (of all ranks) within `bounds` (of all ranks). Bins are as wide as the cutoff, wider
/// where that would give many more bins than particles.
/// @throws ConfigError if a periodic length is below two cutoffs: a pair could then touch through two images at once.
[[nodiscard]] BinLattice make_bin_lattice(const Domain& domain, const Bounds& bounds, double cutoff, std::int64_t particles);

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the halo cells of a block really lie: found by walking through its sides, also round edges and corners.
#include "core/grid/topology.hpp"
#include <algorithm>

namespace core {

/// A cell somewhere in the domain, seen from a block.
struct HaloSource {
    BlockId block = -1;
    Index3 cell;
    Motion motion; ///< carries positions seen from here to positions in its own block
    double weight = 1;
};

/// The sources of one halo cell. One source as a rule; beyond a side whose points do not match those of its neighbour, the cells
/// between which it is interpolated; round a singular edge of the grid (where three or five blocks meet) the different ways round
/// are averaged; beyond a re-entrant edge of the domain it is continued linearly, with weights 1, 1 and -1; none beyond a boundary.
struct HaloRow {
    Index3 cell;
    std::vector<HaloSource> sources;
    bool round_edge = false; ///< averaged or continued
};

enum class HaloShape {
    faces, ///< only cells straight beyond a side
    full,  ///< edges and corners too
    hats   ///< the same, but beyond sides whose points do not match no weight is negative: for what grains sample and deposit
};

/// What a stencil reads around a block.
struct HaloReach {
    int width = 0; ///< layers
    HaloShape shape = HaloShape::full;
    bool operator==(const HaloReach&) const = default;
    auto operator<=>(const HaloReach&) const = default;
};

/// The cells straight beyond the sides.
inline constexpr HaloReach beside{1, HaloShape::faces};

/// What covers both. Hats are less accurate: a field has either them or the others.
[[nodiscard]] constexpr HaloReach joined(HaloReach a, HaloReach b) { return {std::max(a.width, b.width), std::max(a.shape, b.shape)}; }

/// Rows of all halo cells of a block up to `width` layers that have a source, in index order.
[[nodiscard]] std::vector<HaloRow> halo_rows(const Topology& topology, BlockId block, int width, HaloShape shape);

} // namespace core

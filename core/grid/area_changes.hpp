// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What faces beside an interface of sub-faces gain by the bending of its edges.
#include "core/grid/side_overlap.hpp"
#include "core/grid/topology.hpp"

namespace core {

/// The overlaps in which a side is not the master.
struct BentSide {
    BlockId block;
    Side side;
    std::vector<const SideOverlap*> overlaps;
};

/// Changes of the faces between the cells beside such sides, of the same faces seen from blocks beyond, and of the boundary
/// faces next to them.
[[nodiscard]] std::vector<AreaChange> area_changes(const MultiBlock& grid, const Topology& topology, const std::vector<BentSide>& sides);

} // namespace core

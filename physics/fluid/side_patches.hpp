// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where sides of blocks lie on each other cell by cell, from the links of a level: there grid lines go on in the next block.
#include "core/comm/communicator.hpp"
#include "physics/fluid/multigrid_mesh.hpp"
#include <array>
#include <vector>

namespace physics {

/// A rectangle of cells along a side of a block, each with one cell of another side beyond, seen from the first block.
struct SidePatch {
    core::BlockId from = 0, to = 0;
    core::Side side = core::Side::i_low, beyond = core::Side::i_low; ///< of `from` and of `to`
    core::Index3 low, high;                                          ///< cells of `from`, half open
    core::Index3 base;                                               ///< cell of `to` beyond `low`
    std::array<core::Index3, 3> step;                                ///< of the cell beyond, for a step along each axis of `from`

    [[nodiscard]] std::ptrdiff_t size() const { return core::Extents{high.i - low.i, high.j - low.j, high.k - low.k}.size(); }
    [[nodiscard]] bool contains(core::Index3 c) const
    {
        return c.i >= low.i && c.j >= low.j && c.k >= low.k && c.i < high.i && c.j < high.j && c.k < high.k;
    }
    /// The cell of `to` that touches cell c of `from`.
    [[nodiscard]] core::Index3 across(core::Index3 c) const
    {
        core::Index3 other = base;
        for (int axis = 0; axis < 3; ++axis)
            for (int n = 0; n < 3; ++n) other[n] += (c[axis] - low[axis]) * step[std::size_t(axis)][n];
        return other;
    }
};

/// The patches between all blocks of a level, of all ranks, each seen from both of its blocks; sorted by block and side. Sides that
/// touch only in sub-faces have none. Collective.
/// @param ranks  That share the blocks: self() where each has all.
[[nodiscard]] std::vector<SidePatch> side_patches(const BlockTopology& level, const core::Communicator& ranks);

} // namespace physics

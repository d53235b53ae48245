// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a linear solver knows of the mesh: the sizes of all blocks, who owns them, and the links between their sides.
#include "core/grid/extents.hpp"
#include <vector>

namespace physics {

/// Cell index within its block: i + ni * (j + nj * k).
[[nodiscard]] inline int cell_index(core::Extents cells, int i, int j, int k) { return i + cells.ni * (j + cells.nj * k); }
[[nodiscard]] inline core::Index3 cell_place(core::Extents cells, int cell)
{
    return {cell % cells.ni, cell / cells.ni % cells.nj, cell / (cells.ni * cells.nj)};
}

/// One end of a link: a cell on a side of a block.
struct LinkEnd {
    core::BlockId block = 0;
    int cell = 0; ///< see cell_index()
    core::Side side = core::Side::i_low;
    auto operator<=>(const LinkEnd&) const = default;
};

/// The value beyond is zero: a wall that holds the unknown.
inline constexpr core::BlockId wall_block = -1;

/// A face or sub-face between two cells of different sides; the second end may be a wall. Sides need not match.
struct BlockLink {
    LinkEnd a, b;
};

/// All blocks, and the links that touch the blocks of this rank. Blocks of a rank are numbered in the order of their ids.
struct BlockTopology {
    std::vector<core::Extents> cells; ///< of every block, by id
    std::vector<int> owner;           ///< rank of every block, by id
    int rank = 0;
    std::vector<BlockLink> links;
};

/// Number of cells of all blocks.
[[nodiscard]] inline std::ptrdiff_t cell_count(const BlockTopology& topology)
{
    std::ptrdiff_t n = 0;
    for (const auto& c : topology.cells) n += c.size();
    return n;
}

} // namespace physics

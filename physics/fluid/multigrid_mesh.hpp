// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The symbolic half of a grid level: where cells lie, which links join them, what crosses ranks. Built once per mesh.
#include "physics/fluid/block_layout.hpp"
#include "physics/fluid/block_topology.hpp"
#include <array>
#include <vector>

namespace physics {

/// One link as one of its cells sees it.
struct HalfLink {
    int cell = 0;  ///< flat place of the cell
    int other = 0; ///< flat place of the value beyond: a cell, a ghost, or zero behind a wall
    int link = 0;
    int partner = -1; ///< half of the same link at the other end, -1 where that is not on this rank
};

/// All links of one cell on one side of its block: halves [first, last).
struct SideRun {
    core::LocalBlock block = 0;
    int cell = 0; ///< index within the block
    core::Side side = core::Side::i_low;
    int first = 0, last = 0;
};

/// The link of the next level that takes a link in.
struct CoarseLink {
    int link = -1;       ///< -1: none
    bool turned = false; ///< its first end holds the second end of the fine link
};

/// Values that this rank sends to, and ghosts that it receives from, one other rank.
struct GhostExchange {
    int rank = 0;
    std::vector<int> send;      ///< flat places
    std::ptrdiff_t receive = 0; ///< flat place of the first ghost
    int ghosts = 0;
    std::vector<int> links; ///< links between the two ranks, same order on both
};

struct LevelMesh {
    LevelMesh(BlockLayout cells, std::vector<BlockLink> between) : layout(std::move(cells)), links(std::move(between)) {}

    BlockLayout layout;
    std::vector<BlockLink> links;            ///< low end first, sorted
    std::vector<HalfLink> halves;            ///< sorted by cell, side, and what lies beyond
    std::vector<int> piece_halves;           ///< first half of each piece of the layout, and the end
    std::vector<std::array<int, 2>> half_of; ///< halves of the two ends of a link, -1 where not on this rank
    std::vector<SideRun> runs;               ///< sorted by block
    std::vector<int> block_runs;             ///< first run of each block, and the end
    std::vector<CoarseLink> coarse_link;     ///< of each link; empty on the coarsest level
    std::vector<GhostExchange> exchanges;    ///< sorted by rank
};

/// Ends of every link in order, links sorted; links of a cell with itself are left out.
/// @param[out] source  For each link its number in `links`.
[[nodiscard]] std::vector<BlockLink> canonical_links(const std::vector<BlockLink>& links, std::vector<int>& source);

/// @param topology  links must be canonical.
[[nodiscard]] LevelMesh make_level_mesh(const BlockTopology& topology);

/// The mesh with every second cell in each direction; equal links joined.
/// @param[out] coarse_link  For each link of `fine` its link in the result.
[[nodiscard]] BlockTopology coarsened(const BlockTopology& fine, std::vector<CoarseLink>& coarse_link);

[[nodiscard]] inline core::Extents coarsened(core::Extents c) { return {(c.ni + 1) / 2, (c.nj + 1) / 2, (c.nk + 1) / 2}; }

/// The same sizes, without links.
[[nodiscard]] BlockTopology coarsened(const BlockTopology& fine);

} // namespace physics

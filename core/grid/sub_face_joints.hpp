// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sides of blocks that meet without matching points: what carries flow between them are sub-faces, the pieces into which the
// faces of the two sides cut each other (NUMERICS B8).
#include "core/grid/multi_block.hpp"

namespace core {

/// A place on a side of a block: (p, q) counted in faces along the two axes of the side, whole numbers at vertices.
struct SidePlace {
    BlockId block = -1;
    Side side = Side::i_low;
    double p = 0, q = 0;
    Motion motion; ///< carries positions as asked to positions in that block
};

/// A sub-face between cell `a` of one block and cell `b` of another. All vectors as the block of `a` has them.
struct JoinedSubFace {
    Index3 a, b;
    Vec3 area;               ///< from a to b [m2]
    double transmissibility; ///< |S|^2 / (S . d), d from centre to centre [m]
    Vec3 cross;              ///< S - T d [m2]
    Vec3 from_a, from_b;     ///< from the centres of the cells to its own [m]
    SidePlace on_a, on_b;    ///< where its centre lies
    double weight;           ///< share of b in the linear interpolation to it, across the sides
};

/// Two sides that lie on each other, wholly or in part.
struct SubFaceInterface {
    SideContact contact; ///< `a` is the master: its edges stay straight (side_overlap.hpp)
    std::vector<JoinedSubFace> faces;
};

/// What a face beside an interface gains by the bending of its edge, so that the cells on both sides of it stay closed.
struct AreaChange {
    BlockId block;
    int axis;    ///< of the face
    Index3 face; ///< the low face of this cell
    Vec3 area;   ///< towards increasing index [m2]
};

struct SubFaceJoints {
    std::vector<SubFaceInterface> interfaces;
    /// [block][side]: for each face of a joined side, the first tangential axis fastest, where its centre lies on another side.
    /// Empty for other sides; no blocks at all where all points match.
    std::vector<std::array<std::vector<SidePlace>, 6>> places;
    std::vector<AreaChange> area_changes;

    /// Does this side of a block meet others at sub-faces?
    [[nodiscard]] bool joins(BlockId block, Side side) const
    {
        return !places.empty() && !places[std::size_t(block)][std::size_t(side)].empty();
    }
};

} // namespace core

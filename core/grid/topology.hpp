// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who touches whom: sides of blocks that meet, in any orientation, inside the domain or through a period (a shift or a turn),
// point by point or at sub-faces; and the sides that meet nobody.
#include "core/grid/index_map.hpp"
#include "core/grid/sub_face_joints.hpp"
#include <algorithm>
#include <optional>

namespace core {

/// What lies beyond a side of a block.
struct Neighbour {
    BlockId block = -1;
    Side side = Side::i_low; ///< side of that block which is met
    IndexMap map;            ///< cells of this block, continued beyond the side, in that block's indices
    Motion motion;           ///< carries positions here to positions there
};

/// A pair of sides that meet, told once: `a` is the lower (block, side).
struct Interface {
    BlockId a = -1, b = -1;
    Side side_a = Side::i_low, side_b = Side::i_low;
    IndexMap a_to_b;
    Motion motion; ///< from a to b
};

/// A side that meets no other.
struct Boundary {
    BlockId block = -1;
    Side side = Side::i_low;
    std::string name;
};

struct Topology {
    std::vector<Extents> cells; ///< of every block
    std::vector<Interface> interfaces;
    SubFaceJoints joints; ///< the sides that meet others without matching points
    std::vector<Boundary> boundaries;
    std::vector<std::array<std::optional<Neighbour>, 6>> neighbours; ///< [block][side]

    [[nodiscard]] const std::optional<Neighbour>& neighbour(BlockId block, Side side) const
    {
        return neighbours[std::size_t(block)][std::size_t(side)];
    }
    /// Does any side meet another by a turn?
    [[nodiscard]] bool turns() const
    {
        return std::any_of(interfaces.begin(), interfaces.end(), [](const Interface& f) { return f.motion.turns; });
    }
    /// Is this side a boundary of the domain?
    [[nodiscard]] bool at_boundary(BlockId block, Side side) const { return !neighbour(block, side) && !joints.joins(block, side); }
};

/// Finds the sides that meet point by point, and joins those of grid.contacts at sub-faces. Of sides that match, the vertices of
/// the higher block are set to those of the lower one, so that both see the same surface to the last bit (to round-off through a
/// period).
/// @throws ConfigError if a side meets more than one other point by point, or if one of a contact cannot be joined.
[[nodiscard]] Topology match_sides(MultiBlock& grid);

} // namespace core

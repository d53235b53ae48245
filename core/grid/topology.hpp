// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who touches whom: sides of blocks that meet, in any orientation, inside the domain or through a period; and the
// sides that meet nobody.
#include "core/grid/index_map.hpp"
#include "core/grid/multi_block.hpp"
#include <optional>

namespace core {

/// What lies beyond a side of a block.
struct Neighbour {
    BlockId block = -1;
    Side side = Side::i_low;   ///< side of that block which is met
    IndexMap map;              ///< cells of this block, continued beyond the side, in that block's indices
    Vec3 shift = Vec3::Zero(); ///< position there = position here + shift
};

/// A pair of sides that meet, told once: `a` is the lower (block, side).
struct Interface {
    BlockId a = -1, b = -1;
    Side side_a = Side::i_low, side_b = Side::i_low;
    IndexMap a_to_b;
    Vec3 shift = Vec3::Zero();
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
    std::vector<Boundary> boundaries;
    std::vector<std::array<std::optional<Neighbour>, 6>> neighbours; ///< [block][side]

    [[nodiscard]] const std::optional<Neighbour>& neighbour(BlockId block, Side side) const
    {
        return neighbours[std::size_t(block)][std::size_t(side)];
    }
};

/// Finds the sides that meet. The vertices of the higher block of each pair are set to those of the lower one, so that
/// both see the same surface to the last bit (to round-off through a period).
/// @throws ConfigError if a side meets more than one other.
[[nodiscard]] Topology match_sides(MultiBlock& grid);

} // namespace core

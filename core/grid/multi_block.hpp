// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The vertices of all blocks as a generator or a grid file gives them, before anyone knows who touches whom.
#include "core/base/vec3.hpp"
#include "core/field/array3.hpp"
#include "core/grid/motion.hpp"
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace core {

/// The vertices of one block, (ni + 1, nj + 1, nk + 1) [m].
using Vertices = Array3<Vec3>;

/// Two sides of blocks that lie on each other, wholly or in part, though their points do not match.
struct SideContact {
    BlockId a = -1, b = -1;
    Side side_a = Side::i_low, side_b = Side::i_low;
    Vec3 shift = Vec3::Zero(); ///< position on b = position on a + shift
};

struct MultiBlock {
    std::vector<Vertices> blocks;
    /// Translations that carry the domain onto itself [m].
    std::vector<Vec3> periods;
    /// The same by turning it. Sides that it lays on each other must match point by point.
    std::optional<PeriodicTurn> turn;
    /// Sides without matching points that the flow goes through; each must be covered as a whole (touching_sides.hpp finds them).
    std::vector<SideContact> contacts;
    /// Vertices of sides that meet are at most this share of the side's smallest edge apart.
    double match_tolerance = 1e-6;
    /// Name of the boundary that an unmatched side belongs to.
    std::function<std::string(BlockId, Side)> boundary_name = [](BlockId, Side) { return std::string("wall"); };
};

/// Number of cells of a block with these vertices.
[[nodiscard]] inline Extents cells_of(const Vertices& v) { return {v.extents().ni - 1, v.extents().nj - 1, v.extents().nk - 1}; }

} // namespace core

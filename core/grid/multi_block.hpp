// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The vertices of all blocks as a generator or a grid file gives them, before anyone knows who touches whom.
#include "core/base/vec3.hpp"
#include "core/field/array3.hpp"
#include <functional>
#include <string>
#include <vector>

namespace core {

/// The vertices of one block, (ni + 1, nj + 1, nk + 1) [m].
using Vertices = Array3<Vec3>;

struct MultiBlock {
    std::vector<Vertices> blocks;
    /// Translations that carry the domain onto itself [m].
    std::vector<Vec3> periods;
    /// Vertices of sides that meet are at most this share of the side's smallest edge apart.
    double match_tolerance = 1e-6;
    /// Name of the boundary that an unmatched side belongs to.
    std::function<std::string(BlockId, Side)> boundary_name = [](BlockId, Side) { return std::string("wall"); };
};

/// Number of cells of a block with these vertices.
[[nodiscard]] inline Extents cells_of(const Vertices& v)
{
    return {v.extents().ni - 1, v.extents().nj - 1, v.extents().nk - 1};
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The blocks of this rank as results and pictures want them.
#include "core/grid/mesh.hpp"
#include "io/files/block_nodes.hpp"
#include "io/files/field_views.hpp"

namespace io {

[[nodiscard]] inline BlockList blocks_of(const core::Mesh& mesh) { return {mesh.own(), mesh.blocks()}; }

/// Of the blocks of this rank, in local order.
[[nodiscard]] inline std::vector<BlockNodes> nodes_of(const core::Mesh& mesh)
{
    std::vector<BlockNodes> nodes;
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const core::Vertices& vertices = mesh.vertices(mesh.global(b));
        BlockNodes& block = nodes.emplace_back(BlockNodes{core::cells_of(vertices), {}});
        core::for_each_cell(vertices.extents(), [&](int i, int j, int k) {
            const core::Vec3& x = vertices(i, j, k);
            block.points.insert(block.points.end(), {x.x(), x.y(), x.z()});
        });
    }
    return nodes;
}

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/mesh.hpp"
#include "core/base/error.hpp"
#include "core/grid/partition.hpp"
#include "core/grid/sub_face_values.hpp"
#include "core/grid/touching_sides.hpp"

namespace core {

Mesh::Mesh(MultiBlock grid, int rank, int ranks) : grid_(std::move(grid))
{
    require<ConfigError>(!grid_.blocks.empty(), "the grid has no blocks");
    for (std::size_t b = 0; b < grid_.blocks.size(); ++b) total_volume_ += checked_volume(grid_, BlockId(b));
    topology_ = match_sides(grid_);
    require_turn_joins(grid_, topology_);
    owner_ = partition(topology_.cells, ranks);
    local_.assign(owner_.size(), -1);
    for (BlockId b = 0; b < blocks(); ++b) {
        if (owner(b) != rank) continue;
        local_[std::size_t(b)] = own_count();
        own_.push_back(b);
        own_cells_.push_back(cells(b));
        const SubFaceValues values = sub_face_values(topology_, b);
        own_cells_.back().sub_face_values = values.count();
        own_cells_.back().sub_faces = int(values.faces.size());
        geometry_.push_back(make_geometry(grid_, topology_, b));
    }
}

std::int64_t Mesh::total_cells() const
{
    std::int64_t total = 0;
    for (const Extents e : topology_.cells) total += e.size();
    return total;
}

} // namespace core

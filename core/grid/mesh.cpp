// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/mesh.hpp"
#include "core/base/error.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/partition.hpp"

namespace core {
namespace {

constexpr double smallest_jacobian = 1e-8; // of the product of the edges at a corner

/// @return volume of the block [m3].
double checked_volume(const MultiBlock& grid, BlockId block)
{
    const Vertices& v = grid.blocks[std::size_t(block)];
    double volume = 0;
    for_each_cell(cells_of(v), [&](int i, int j, int k) {
        const double jacobian = smallest_corner_jacobian(v, {i, j, k});
        if (!(jacobian > smallest_jacobian))
            throw ConfigError(text("cell (", i, ", ", j, ", ", k, ") of block ", block, " is folded or flat: its smallest corner Jacobian is ",
                                   jacobian, " of the product of its edges"));
        volume += cell_shape(v, {i, j, k}).volume;
    });
    return volume;
}

} // namespace

Mesh::Mesh(MultiBlock grid, int rank, int ranks) : grid_(std::move(grid))
{
    require<ConfigError>(!grid_.blocks.empty(), "the grid has no blocks");
    for (std::size_t b = 0; b < grid_.blocks.size(); ++b) total_volume_ += checked_volume(grid_, BlockId(b));
    topology_ = match_sides(grid_);
    owner_ = partition(topology_.cells, ranks);
    local_.assign(owner_.size(), -1);
    for (BlockId b = 0; b < blocks(); ++b) {
        if (owner(b) != rank) continue;
        local_[std::size_t(b)] = own_count();
        own_.push_back(b);
        own_cells_.push_back(cells(b));
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

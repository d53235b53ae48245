// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The world as one rank sees it: the topology and the vertices of all blocks, the metrics of its own.
#include "core/grid/geometry.hpp"
#include "core/grid/halo_map.hpp"
#include "core/grid/topology.hpp"

namespace core {

class Mesh {
public:
    /// @param rank, ranks  This rank and their number; every rank passes the same grid.
    /// @throws ConfigError naming block and cell if a cell is folded or flat.
    Mesh(MultiBlock grid, int rank, int ranks);

    [[nodiscard]] const Topology& topology() const { return topology_; }
    [[nodiscard]] int blocks() const { return int(topology_.cells.size()); }
    [[nodiscard]] Extents cells(BlockId b) const { return topology_.cells[std::size_t(b)]; }
    [[nodiscard]] const Vertices& vertices(BlockId b) const { return grid_.blocks[std::size_t(b)]; }
    [[nodiscard]] const std::vector<Vec3>& periods() const { return grid_.periods; }
    [[nodiscard]] const std::optional<PeriodicTurn>& turn() const { return grid_.turn; }
    [[nodiscard]] int owner(BlockId b) const { return owner_[std::size_t(b)]; }
    [[nodiscard]] const std::vector<int>& owners() const { return owner_; }

    /// Blocks of this rank, ascending.
    [[nodiscard]] const std::vector<BlockId>& own() const { return own_; }
    [[nodiscard]] int own_count() const { return int(own_.size()); }
    [[nodiscard]] BlockId global(LocalBlock b) const { return own_[std::size_t(b)]; }
    /// Index among the blocks of this rank, or -1.
    [[nodiscard]] LocalBlock local(BlockId b) const { return local_[std::size_t(b)]; }
    /// Extents of the blocks of this rank, as fields want them.
    [[nodiscard]] const std::vector<Extents>& own_cells() const { return own_cells_; }
    [[nodiscard]] const BlockGeometry& geometry(LocalBlock b) const { return geometry_[std::size_t(b)]; }
    /// Is this side of a block of this rank a boundary of the domain?
    [[nodiscard]] bool at_boundary(LocalBlock b, Side s) const { return topology_.at_boundary(global(b), s); }

    [[nodiscard]] std::int64_t total_cells() const;
    [[nodiscard]] double total_volume() const { return total_volume_; } ///< of all blocks [m3]

private:
    MultiBlock grid_;
    Topology topology_;
    std::vector<int> owner_;
    std::vector<BlockId> own_;
    std::vector<LocalBlock> local_;
    std::vector<Extents> own_cells_;
    std::vector<BlockGeometry> geometry_;
    double total_volume_ = 0;
};

/// Volume of a block [m3].
/// @throws ConfigError naming block and cell if a cell is folded or flat.
[[nodiscard]] double checked_volume(const MultiBlock& grid, BlockId block);

/// The metrics of one block, with the centres of its neighbours' cells in its halo.
[[nodiscard]] BlockGeometry make_geometry(const MultiBlock& grid, const Topology& topology, BlockId block);

} // namespace core

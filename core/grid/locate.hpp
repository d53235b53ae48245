// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From a point to the cell that holds it and its place inside: the mapped-space position of Ushijima & Nezu (2001),
// eqs (9)-(10), made robust (NUMERICS A15): Newton on the trilinear map, stepping from cell to cell and block to block.
#include "core/grid/mesh.hpp"

namespace core {

struct Location {
    BlockId block = -1;
    Index3 cell;
    Vec3 xi = Vec3::Zero(); ///< in [0, 1]^3, along i, j, k of the cell
};

class Locator {
public:
    /// The mesh must outlive the locator.
    explicit Locator(const Mesh& mesh);
    [[nodiscard]] const Mesh& mesh() const { return *mesh_; }

    /// The cell of `x` [m], found from nothing. A point beyond a boundary by less than `tolerance_cells` of a cell counts
    /// as on it (curved walls bulge beyond their flat faces). Nothing if no cell holds it.
    [[nodiscard]] std::optional<Location> find(const Vec3& x) const;
    /// The same to the last bit, started from a place nearby: fast when x moved by less than a cell or so. A point beyond a
    /// periodic side is found at the other end.
    [[nodiscard]] std::optional<Location> find(const Vec3& x, const Location& near) const;
    /// The rank that owns the cell of `x`; a rank with a cell nearby, or 0, where no cell holds it.
    [[nodiscard]] int owner(const Vec3& x) const;
    /// The point at a location [m].
    [[nodiscard]] Vec3 position(const Location& at) const;

    static constexpr double tolerance_cells = 0.5;

private:
    struct Bins {
        Vec3 low, size;
        Extents count;
        std::vector<int> first;                        ///< of each bin in `cells`
        std::vector<std::pair<BlockId, Index3>> cells; ///< whose bounding boxes touch the bin
        std::vector<int> owner;                        ///< of all cells of a bin; -1 where they have several
    };
    [[nodiscard]] std::optional<Location> walk(const Vec3& x, Location at, int steps) const;
    [[nodiscard]] std::optional<Location> find_beyond_seams(const Vec3& x) const;
    [[nodiscard]] Index3 bin_of(const Vec3& x) const;
    [[nodiscard]] std::size_t bin_number(const Vec3& x) const;
    void find_owners();

    const Mesh* mesh_; // never null
    Bins bins_;
};

} // namespace core

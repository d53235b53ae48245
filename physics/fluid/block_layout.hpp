// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the cells of a rank's blocks lie in one flat array, and how its loops are cut into pieces.
#include "core/base/team.hpp"
#include "core/field/field.hpp"
#include <cstddef>
#include <span>
#include <vector>

namespace physics {

/// Part `part` of `parts` of a block.
struct Piece {
    core::LocalBlock block = 0;
    int part = 0, parts = 1;
    std::ptrdiff_t begin = 0, end = 0; ///< flat range of whole rows along i
    [[nodiscard]] int first(int n) const { return int(std::ptrdiff_t(n) * part / parts); }
    [[nodiscard]] int last(int n) const { return int(std::ptrdiff_t(n) * (part + 1) / parts); }
};

/// Blocks one after the other, each cell array dense with i fastest. Between blocks, before the first and after the last
/// lies at least one k-plane of padding, which always holds zero: a stencil with zero coefficients on the block's
/// boundary needs no branch. The places of ghost cells follow.
class BlockLayout {
public:
    /// @param ids    Global ids, ascending.
    /// @param cells  Extents of the same blocks.
    BlockLayout(std::vector<core::BlockId> ids, std::vector<core::Extents> cells, std::size_t ghosts);

    [[nodiscard]] int blocks() const { return int(ids_.size()); }
    [[nodiscard]] core::BlockId id(core::LocalBlock b) const { return ids_[std::size_t(b)]; }
    [[nodiscard]] std::span<const core::BlockId> ids() const { return ids_; }
    [[nodiscard]] core::Extents cells(core::LocalBlock b) const { return cells_[std::size_t(b)]; }
    /// Flat index of cell (0, 0, 0).
    [[nodiscard]] std::ptrdiff_t origin(core::LocalBlock b) const { return origins_[std::size_t(b)]; }
    [[nodiscard]] std::ptrdiff_t ghost_origin() const { return ghost_origin_; }
    /// Length of a flat array, padding and ghosts included.
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t cell_count() const { return cell_count_; }
    [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
    [[nodiscard]] core::View<double> view(core::LocalBlock b, std::span<double> values) const
    {
        return {values.data() + origin(b), cells(b), 0};
    }

    /// Calls body(piece number) for every piece; small pieces share a chunk.
    template <class Body>
    void for_pieces(const core::Team& team, Body body) const
    {
        team.run(int(chunks_.size()) - 1, [&](int c) {
            for (int p = chunks_[std::size_t(c)]; p < chunks_[std::size_t(c) + 1]; ++p) body(p);
        });
    }

private:
    void cut_into_pieces();

    std::vector<core::BlockId> ids_;
    std::vector<core::Extents> cells_;
    std::vector<std::ptrdiff_t> origins_;
    std::ptrdiff_t ghost_origin_ = 0;
    std::size_t size_ = 0, cell_count_ = 0;
    std::vector<Piece> pieces_;
    std::vector<int> chunks_; // first piece of each chunk, and the end
};

} // namespace physics

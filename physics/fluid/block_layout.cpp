// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/block_layout.hpp"

#include <algorithm>

namespace physics {

BlockLayout::BlockLayout(std::vector<core::BlockId> ids, std::vector<core::Extents> cells, std::size_t ghosts)
    : ids_(std::move(ids)), cells_(std::move(cells))
{
    std::ptrdiff_t next = 0;
    for (const auto& c : cells_) {
        const std::ptrdiff_t plane = std::ptrdiff_t(c.ni) * c.nj;
        const std::ptrdiff_t before =
            origins_.empty() ? 0 : std::ptrdiff_t(cells_[origins_.size() - 1].ni) * cells_[origins_.size() - 1].nj;
        next += std::max({plane, before, std::ptrdiff_t(1)});
        origins_.push_back(next);
        next += c.size();
        cell_count_ += std::size_t(c.size());
    }
    next += cells_.empty() ? 1 : std::ptrdiff_t(cells_.back().ni) * cells_.back().nj;
    ghost_origin_ = next;
    size_ = std::size_t(next) + ghosts;
    cut_into_pieces();
}

void BlockLayout::cut_into_pieces()
{
    constexpr std::ptrdiff_t piece_cells = 16384; // some 10 us of a sweep; its share of all arrays stays in the L2 cache
    std::ptrdiff_t in_chunk = 0;
    for (core::LocalBlock b = 0; b < blocks(); ++b) {
        const auto c = cells(b);
        const std::ptrdiff_t rows = std::ptrdiff_t(c.nj) * c.nk;
        const int parts = int(std::clamp<std::ptrdiff_t>((c.size() + piece_cells - 1) / piece_cells, 1, rows));
        for (int p = 0; p < parts; ++p) {
            const auto begin = origin(b) + rows * p / parts * c.ni, end = origin(b) + rows * (p + 1) / parts * c.ni;
            if (chunks_.empty() || in_chunk + (end - begin) > piece_cells) {
                chunks_.push_back(int(pieces_.size()));
                in_chunk = 0;
            }
            in_chunk += end - begin;
            pieces_.push_back({b, p, parts, begin, end});
        }
    }
    if (chunks_.empty()) chunks_.push_back(0);
    chunks_.push_back(int(pieces_.size()));
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sums over all cells whose bits depend neither on threads nor on ranks: pieces in order, then blocks by id.
#include "physics/fluid/block_layout.hpp"
#include <array>
#include <span>
#include <vector>

namespace physics {

class BlockSums {
public:
    static constexpr int most = 4; ///< sums formed in one pass

    /// @param all_blocks  Number of blocks of all ranks.
    BlockSums(const BlockLayout& layout, int all_blocks)
        : layout_(&layout), of_pieces_(layout.pieces().size()), of_blocks_(std::size_t(all_blocks) * most, 0.0)
    {
    }

    /// body(begin, end) gives the sums over a flat range, as an array of at most `most` numbers.
    template <class Body>
    void form(const core::Team& team, Body body)
    {
        layout_->for_pieces(team, [&](int n) {
            const auto& piece = layout_->pieces()[std::size_t(n)];
            const auto sums = body(piece.begin, piece.end);
            of_pieces_[std::size_t(n)] = {};
            std::copy(sums.begin(), sums.end(), of_pieces_[std::size_t(n)].begin());
        });
        std::fill(of_blocks_.begin(), of_blocks_.end(), 0.0);
        for (std::size_t n = 0; n < of_pieces_.size(); ++n)
            for (std::size_t s = 0; s < most; ++s)
                of_blocks_[std::size_t(layout_->id(layout_->pieces()[n].block)) * most + s] += of_pieces_[n][s];
    }
    /// Sums of each block, zero for those of other ranks: add them up over the ranks, element by element.
    [[nodiscard]] std::span<double> of_blocks() { return of_blocks_; }
    [[nodiscard]] int all_blocks() const { return int(of_blocks_.size()) / most; }
    [[nodiscard]] double total(int sum) const
    {
        double value = 0.0;
        for (std::size_t b = std::size_t(sum); b < of_blocks_.size(); b += most) value += of_blocks_[b];
        return value;
    }

private:
    const BlockLayout* layout_;
    std::vector<std::array<double, most>> of_pieces_;
    std::vector<double> of_blocks_;
};

/// Sum of term(c) for c in [begin, end), in eight interleaved partial sums: SIMD with a fixed order of additions.
template <class Term>
[[nodiscard]] double ordered_sum(std::ptrdiff_t begin, std::ptrdiff_t end, Term term)
{
    constexpr int lanes = 8;
    double partial[lanes] = {};
    std::ptrdiff_t c = begin;
    for (; c + lanes <= end; c += lanes)
        for (int n = 0; n < lanes; ++n) partial[n] += term(c + n);
    for (int n = 0; c < end; ++c, ++n) partial[n] += term(c);
    return ((partial[0] + partial[4]) + (partial[1] + partial[5])) + ((partial[2] + partial[6]) + (partial[3] + partial[7]));
}

[[nodiscard]] inline double dot(std::ptrdiff_t begin, std::ptrdiff_t end, const double* x, const double* y)
{
    return ordered_sum(begin, end, [=](std::ptrdiff_t c) { return x[c] * y[c]; });
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Factorisation and solution of the tridiagonal systems along the grid lines of a block.
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

/// Replaces the sums of the coefficients across the lines, in level.inverse, by the inverse pivots of the lines of a
/// piece. Free of subtractions, hence accurate at any aspect ratio; a line without ties gets its last cell pinned.
void factorise_lines(const Piece& piece, MultigridLevel& level);
/// Solves the lines of a piece in place.
void solve_lines(const Piece& piece, const MultigridLevel& level, float* values);

/// Calls body(begin, end) for the contiguous flat ranges that hold the lines of a piece.
template <class Body>
void for_line_ranges(const Piece& piece, const BlockLayout& layout, LineAxis axis, Body body)
{
    const auto c = layout.cells(piece.block);
    const std::ptrdiff_t origin = layout.origin(piece.block), plane = std::ptrdiff_t(c.ni) * c.nj;
    if (axis == LineAxis::none || axis == LineAxis::i) {
        body(piece.begin, piece.end);
    } else if (axis == LineAxis::j) {
        body(origin + plane * piece.first(c.nk), origin + plane * piece.last(c.nk));
    } else {
        for (int k = 0; k < c.nk; ++k)
            body(origin + plane * k + std::ptrdiff_t(c.ni) * piece.first(c.nj),
                 origin + plane * k + std::ptrdiff_t(c.ni) * piece.last(c.nj));
    }
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Makes the contacts of a grid whose blocks touch without matching points, and cuts blocks where others end on their sides.
#include "core/grid/multi_block.hpp"

namespace core {

/// A side of a block as it was before any cut.
struct CoveredSide {
    BlockId block = -1;
    Side side = Side::i_low;
    bool wholly = true; ///< else some of its faces are a boundary
};

/// Fills grid.contacts. Blocks of which others cover a side in part are cut there, together with those that match them, so that
/// every side is covered as a whole or a boundary as a whole; the pieces keep the names of their boundaries.
/// @return The sides that others touch.
/// @throws ConfigError naming side and face if others cover a face in part: only lines of the grid can be cut along.
std::vector<CoveredSide> join_touching_blocks(MultiBlock& grid);

} // namespace core

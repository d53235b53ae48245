// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What fields of a block keep behind their halo for the sub-faces on its sides: values of the cells beyond, and values
// interpolated to the sub-faces, the same for both blocks to the last bit.
#include "core/grid/halo_map.hpp"

namespace core {

/// A sub-face as one of the two blocks beside it sees it.
struct BlockSubFace {
    const JoinedSubFace* face;
    bool is_a;     ///< This block has cell `a`.
    Side side;     ///< of this block
    Index3 cell;   ///< of this block
    int beyond;    ///< number of the value of the cell on the other side
    int at_centre; ///< number of the value at the centre of the sub-face
};

/// Values of cells beyond come first, then one for each sub-face.
struct SubFaceValues {
    std::vector<HaloSource> cells;
    std::vector<BlockSubFace> faces; ///< in the order of the interfaces and their sub-faces
    [[nodiscard]] int count() const { return int(cells.size() + faces.size()); }
};

[[nodiscard]] SubFaceValues sub_face_values(const Topology& topology, BlockId block);

/// What makes the value at the centre of a sub-face: linear between the two layers of cells beside it, each interpolated to the centre.
[[nodiscard]] std::vector<HaloSource> centre_sources(const Topology& topology, const JoinedSubFace& face);

} // namespace core

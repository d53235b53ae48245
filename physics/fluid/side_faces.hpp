// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A loop over the faces on one side of a block.
#include "core/grid/extents.hpp"

namespace physics {

/// Calls body(i, j, k) for the faces on one side of a block, in the indices of the FaceView along the side's axis.
template <class Body>
void for_each_side_face(core::Extents cells, core::Side side, Body body)
{
    const int axis = core::axis_of(side);
    core::Index3 low{0, 0, 0}, high{cells.ni, cells.nj, cells.nk};
    low[axis] = core::is_high(side) ? cells[axis] : 0;
    high[axis] = low[axis] + 1;
    core::for_each(low, high, body);
}

} // namespace physics

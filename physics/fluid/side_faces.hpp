// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faces on one side of a block, and the cells beside them.
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

/// The cell of a block at one of the faces on its side.
[[nodiscard]] inline core::Index3 cell_at_face(core::Index3 face, core::Side side)
{
    if (core::is_high(side)) --face[core::axis_of(side)];
    return face;
}

} // namespace physics

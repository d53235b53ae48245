// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether all cells beside interfaces of sub-faces are closed, and what closes them where more than two bent sides meet along a line:
// the edges of each bend to points of its own there, and no face has the gap between them. What the cells around such a line are open
// by cancels in sum, and the sub-faces between them share it out.
#include "core/grid/sub_face_joints.hpp"
#include "core/grid/topology.hpp"

namespace core {

/// Gives a sub-face its area vector, and what follows from it.
/// @pre from_a and from_b are known.
void set_area(const Vec3& area, JoinedSubFace& face);

/// Changes the areas of sub-faces between open cells, by the least that closes them: the sum of |dS|^2 / |S| is smallest. Cells that
/// cannot be closed, or only by more than a third of the area of a sub-face, stay as they are.
/// @param joints  Otherwise complete.
void close_cells(const MultiBlock& grid, SubFaceJoints& joints);

/// @throws ConfigError naming the first cell beside an interface whose area vectors do not add up to zero.
void require_closed_cells(const MultiBlock& grid, const SubFaceJoints& joints);

} // namespace core

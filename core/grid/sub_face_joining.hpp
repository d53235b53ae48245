// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Joins the sides of blocks that meet without matching points.
#include "core/grid/topology.hpp"

namespace core {

/// Joins the sides of grid.contacts.
/// @param topology  With the cells, and the sides that meet point by point.
/// @throws ConfigError naming block and side if a side is covered in part only, if contacts contradict each other, or if a cell
///         beside an interface cannot be closed.
[[nodiscard]] SubFaceJoints join_at_sub_faces(const MultiBlock& grid, const Topology& topology);

} // namespace core

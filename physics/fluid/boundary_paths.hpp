// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the paths of the fluid begin that would come from beyond a boundary.
#include "physics/fluid/boundary.hpp"

namespace physics {

/// Shortens displacements to those from the boundary, where the fields that are carried have the values that hold there (D 20).
/// @param displacement  At most one cell in each direction [cells].
void end_at_boundaries(const BlockWalls& walls, core::VectorView<double> displacement);

} // namespace physics

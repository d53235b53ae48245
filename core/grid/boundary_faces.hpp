// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faces of cells on boundaries of the domain, of all blocks.
#include "core/grid/hexahedron.hpp"
#include "core/grid/mesh.hpp"
#include <algorithm>
#include <span>
#include <string>

namespace core {

/// Calls visit(boundary, face_corners) for each face of the boundaries with these names, in the order of boundaries and cells.
template <class Visit>
void for_each_boundary_face(const Mesh& mesh, std::span<const std::string> names, Visit visit)
{
    for (const Boundary& boundary : mesh.topology().boundaries) {
        if (std::find(names.begin(), names.end(), boundary.name) == names.end()) continue;
        const int axis = axis_of(boundary.side);
        const Extents n = mesh.cells(boundary.block);
        Index3 low, high{n.ni, n.nj, n.nk};
        low[axis] = is_high(boundary.side) ? n[axis] : 0;
        high[axis] = low[axis] + 1;
        for_each(low, high, [&](int i, int j, int k) { visit(boundary, face_corners(mesh.vertices(boundary.block), axis, {i, j, k})); });
    }
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Face area, face centre, volume and centroid of cells with eight corners. A face is four triangles about the mean of
// its corners, so neighbours share it exactly and cells fill space without gaps.
#include "core/base/vec3.hpp"
#include "core/grid/index_map.hpp"
#include "core/grid/multi_block.hpp"

namespace core {

/// Corners of a face in cyclic order.
using Quad = std::array<Vec3, 4>;

struct FaceShape {
    Vec3 area;   ///< vector along +axis [m2]
    Vec3 centre; ///< area-weighted [m]
};

struct CellShape {
    double volume; ///< [m3]
    Vec3 centroid; ///< [m]
};

/// Low-side face of cell (i, j, k) along `axis`; the area vector points to increasing index.
[[nodiscard]] Quad face_corners(const Vertices& vertices, int axis, Index3 cell);
[[nodiscard]] FaceShape face_shape(const Quad& corners);
[[nodiscard]] CellShape cell_shape(const Vertices& vertices, Index3 cell);
/// Smallest of the eight corner Jacobians over the mean edge products; not positive for a folded cell.
[[nodiscard]] double smallest_corner_jacobian(const Vertices& vertices, Index3 cell);

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cross-sections of a field for pictures.
#include "core/field/array3.hpp"
#include "io/files/block_nodes.hpp"
#include "io/picture/picture.hpp"

namespace io {

struct Plane {
    core::Vec3 point{0, 0, 0}, normal{0, 0, 1}; ///< [m], any length
};

/// What the plane cuts out of each hexahedron of a block, in the colour of the cell's value between bar.low and bar.high.
[[nodiscard]] std::vector<ColouredQuad> cut(const BlockNodes& block, core::View<const double> values, const Plane& plane,
                                            const ColourBar& bar);

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The boundary of the domain as one surface of quadrilaterals with shared vertices, as particles and pictures see it.
#include "core/grid/mesh.hpp"

namespace core {

struct Surface {
    std::vector<Vec3> vertices;            ///< each place once [m]
    std::vector<std::array<int, 4>> quads; ///< corners in cyclic order, the normal pointing into the domain
    std::vector<int> name;                 ///< of each, the place of its boundary's name among those that were asked for
};

/// All boundary faces of all blocks whose boundary has one of `names`, the same on every rank. Through periods the
/// surface is continued by `margin` [m] beyond the domain, so that a particle at a seam meets it whole.
[[nodiscard]] Surface boundary_surface(const Mesh& mesh, std::span<const std::string> names, double margin);

} // namespace core

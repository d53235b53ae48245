// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Loose triangles, as files hold them, made into a surface whose triangles share their corners.
#include "core/base/vec3.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace physics {

/// Triangles that share an edge run along it in opposite directions: they agree on which of their sides is which.
struct TriangleMesh {
    std::vector<core::Vec3> vertices; ///< [m]
    std::vector<std::array<int, 3>> triangles;
};

/// Joins corners that lie within 10^-6 of the extent of all, and turns triangles to the side of their neighbours.
/// @throws core::ConfigError for triangles without area, edges of more than two triangles, and surfaces with a single side; the
///         triangles are named by their number, counted from 1.
[[nodiscard]] TriangleMesh joined_triangles(std::span<const std::array<core::Vec3, 3>> triangles);

/// A place on the rim of the surface; none if it is closed [m].
[[nodiscard]] std::optional<core::Vec3> rim_of(const TriangleMesh& mesh);

} // namespace physics

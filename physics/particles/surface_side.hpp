// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which places lie inside a closed surface of triangles.
#include "physics/particles/triangle_mesh.hpp"
#include "physics/particles/walls.hpp"

namespace physics {

/// The side of a closed surface where particles are.
class SurfaceSide {
public:
    /// @throws core::ConfigError if the surface has a rim.
    SurfaceSide(TriangleMesh mesh, WallSide particles);

    /// Whether a place is on that side, but for rounding beside the surface. Counts the triangles above it.
    [[nodiscard]] bool holds(const core::Vec3& place) const;

private:
    [[nodiscard]] bool is_below(const core::Vec3& x, const std::array<int, 3>& triangle) const;
    [[nodiscard]] int turn(const core::Vec3& x, int from, int to) const;
    [[nodiscard]] int bin(int axis, double at) const;

    TriangleMesh mesh_; // tilted
    WallSide particles_;
    core::Vec3 low_, high_;
    int bins_ = 1;                        // along x and along y
    std::vector<std::vector<int>> above_; // triangles over each bin
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which faces of a wall meet smoothly and which in sharp edges and corners, while the wall is built.
#include "core/base/vec3.hpp"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace physics {

/// What lies beyond an edge that one face alone has.
enum class Rims {
    end,  ///< nothing
    go_on ///< the face of another wall with points of its own, where one lies across; of a closed surface, such as that of a grid
};

/// Corner k of a face is its k-th vertex; edge k joins corners k and k + 1.
class WallFaces {
public:
    /// @throws core::ConfigError for corners that do not exist and faces without area.
    WallFaces(std::span<const core::Vec3> vertices, std::span<const std::array<int, 4>> quads, double smooth_angle, Rims rims);

    [[nodiscard]] core::Vec3 corner(int face, int k) const { return vertices_[std::size_t(vertex(face, k))]; }
    /// Normal of the smooth wall that the face belongs to, at its corner. Of faces with three corners each counts by its angle there
    /// (Thuermer and Wuethrich 1998, Computing vertex normals from polygonal facets), so that long triangles on a cylinder give its own.
    [[nodiscard]] core::Vec3 corner_normal(int face, int k) const;
    /// Whether the faces at the edge meet at an angle, or the surface ends there.
    [[nodiscard]] bool sharp(int face, int k) const { return sharp_[std::size_t(face)][std::size_t(k)]; }
    /// In the plane of the face beyond the edge, away from the edge; zero where the surface ends.
    [[nodiscard]] core::Vec3 across(int face, int k) const;
    /// Number of the corner among the sharp ones, or -1.
    [[nodiscard]] int sharp_vertex(int face, int k) const { return sharp_vertex_[std::size_t(vertex(face, k))]; }
    /// Directions of all edges that leave each sharp corner.
    [[nodiscard]] const std::vector<std::vector<core::Vec3>>& spokes() const { return spokes_; }

private:
    [[nodiscard]] int vertex(int face, int k) const { return quads_[std::size_t(face)][std::size_t(k)]; }
    [[nodiscard]] bool has_three_corners(int face) const { return vertex(face, 2) == vertex(face, 3); }
    [[nodiscard]] double share_at(int face, int centre) const;
    [[nodiscard]] int neighbour(int face, int k) const;
    void find_sharp_edges(double smooth_angle);
    void join_rims(double smooth_angle);
    void find_sharp_corners();

    std::span<const core::Vec3> vertices_;
    std::span<const std::array<int, 4>> quads_;
    std::vector<core::Vec3> normal_;                        // twice the area, of each face [m2]
    std::map<std::pair<int, int>, std::vector<int>> edges_; // faces at each edge, lower vertex first
    std::vector<std::array<bool, 4>> sharp_;
    std::vector<int> sharp_vertex_;
    std::vector<std::vector<core::Vec3>> spokes_;
};

} // namespace physics

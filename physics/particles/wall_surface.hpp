// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A wall made of quadrilaterals with shared vertices: smooth patches where they meet at small angles, edges and corners elsewhere.
#include "core/base/vec3.hpp"

#include <array>
#include <span>
#include <vector>

namespace physics {

class WallFaces;

/// Where a sphere may touch the surface.
struct SurfaceHit {
    core::Vec3 normal = core::Vec3::Zero(); ///< From the surface to the centre, of length one.
    double depth = 0.0;                     ///< Distance of the centre from the surface [m].
    int triangle = -1;
};

/// Each quadrilateral is split into four triangles about its centre. A triangle carries the normals of its corners and is
/// bent to them (quadratic patch), so that a coarse pipe is a pipe and rolls like one.
/// @source  Nagata (2005), Simple local interpolation of surfaces using normal vectors: the edge curves.
class WallSurface {
public:
    WallSurface() = default;
    /// @param vertices      Relative to the domain's origin [m]; each place once.
    /// @param quads         Corners in cyclic order; the normal by the right-hand rule points to the particles.
    /// @param smooth_angle  Faces that meet at less than this are one smooth wall [rad].
    /// @throws core::ConfigError for corners that do not exist and faces without area.
    WallSurface(std::span<const core::Vec3> vertices, std::span<const std::array<int, 4>> quads, double smooth_angle = 0.27);

    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    /// Triangles that a sphere about `centre` reaching out to `reach` may touch, in rising order.
    void candidates(const core::Vec3& centre, double reach, std::vector<int>& found) const;
    /// Whether a sphere about `centre` reaching out to `reach` may touch `triangle`.
    [[nodiscard]] bool near(int triangle, const core::Vec3& centre, double reach) const;
    /// Whether the centre faces `triangle` or one of its sharp edges and corners; each place of contact once, up to rounding.
    [[nodiscard]] bool meet(int triangle, const core::Vec3& centre, SurfaceHit& hit) const;
    /// Unit normal of the patch of `hit` where the centre was `way` [m] ago.
    [[nodiscard]] core::Vec3 normal_before(const SurfaceHit& hit, const core::Vec3& centre, const core::Vec3& way) const;

private:
    struct Triangle {
        std::array<core::Vec3, 3> corner;
        std::array<core::Vec3, 3> normal;     ///< Of the smooth wall at the corners.
        std::array<core::Vec3, 3> bend;       ///< Of the edges opposite to the corners [m].
        core::Vec3 dual_one, dual_two;        ///< Barycentric coordinates 1 and 2 of x: dual . (x - corner[0]).
        std::array<bool, 3> sharp{};          ///< Edge opposite to the corner.
        std::array<core::Vec3, 3> across;     ///< In the neighbour's plane, away from that edge; zero at the rim of the surface.
        std::array<int, 3> vertex{-1, -1, -1};///< Number of the corner if it is sharp, or -1.
        bool flat = true;
    };
    struct Foot {
        std::array<double, 3> weight;
        core::Vec3 point, normal;
        double depth;
    };
    void add_triangles(const WallFaces& faces, int face);
    void fill_bins();
    [[nodiscard]] static Foot foot(const Triangle& triangle, const core::Vec3& centre);
    [[nodiscard]] bool meet_edge(const Triangle& triangle, int edge, const core::Vec3& centre, SurfaceHit& hit) const;
    [[nodiscard]] bool meet_corner(const Triangle& triangle, int corner, const core::Vec3& centre, SurfaceHit& hit) const;
    [[nodiscard]] std::array<int, 3> bin(const core::Vec3& x) const;

    std::vector<Triangle> triangles_;
    std::vector<std::vector<core::Vec3>> spokes_; // directions of the edges from each sharp corner
    core::Vec3 low_ = core::Vec3::Zero(), high_ = core::Vec3::Zero();
    std::array<int, 3> bins_{1, 1, 1};
    double bin_width_ = 1.0;
    std::vector<int> bin_start_, bin_triangle_;
};

} // namespace physics

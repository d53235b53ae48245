// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A wall made of quadrilaterals with shared vertices: smooth patches where they meet at small angles, edges and corners elsewhere.
#include "physics/particles/wall_patch.hpp"

#include <span>
#include <vector>

namespace physics {

class WallFaces;
struct TriangleMesh;

/// Where a sphere may touch the surface.
struct SurfaceHit {
    core::Vec3 normal = core::Vec3::Zero(); ///< From the surface to the centre, of length one.
    double depth = 0.0;                     ///< Distance of the centre from the surface [m].
};

/// Where a centre must lie to be near a triangle: its height and its coordinates along the edges, each as three factors and
/// an offset; then the lowest and highest height, and the least of the three coordinates.
struct CentreBounds {
    static constexpr std::size_t size = 17;
    std::array<double, size> value;
};

/// A foot this far outside a triangle still counts [-]: neighbours overlap a little, and of two hits with one normal only the
/// deeper is kept.
inline constexpr double patch_overlap = 1e-3;

/// Each quadrilateral is split into four triangles about its centre. A triangle carries the normals of its corners and is
/// bent to them (quadratic patch), so that a coarse pipe is a pipe and rolls like one.
/// @source  Nagata (2005), Simple local interpolation of surfaces using normal vectors: the edge curves.
class WallSurface {
public:
    WallSurface() = default;
    /// @param vertices      Relative to the domain's origin [m]; each place once.
    /// @param quads         Corners in cyclic order; the normal by the right-hand rule points to the particles.
    /// @param smooth_angle  Faces that meet at less than this are one smooth wall [rad].
    /// @param materials     One for each face, or one for all.
    /// @throws core::ConfigError for corners that do not exist and faces without area.
    WallSurface(std::span<const core::Vec3> vertices, std::span<const std::array<int, 4>> quads, double smooth_angle = 0.27,
                std::span<const int> materials = {});

    /// Of triangles; particles meet it from both sides.
    WallSurface(const TriangleMesh& mesh, double smooth_angle, int material = 0);

    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    /// Whether particles meet it from both sides, or stay on that of the normal.
    [[nodiscard]] bool two_sided() const { return two_sided_; }
    /// Triangles that a sphere about `centre` may touch when it has gone up to `skin` [m], in rising order.
    void candidates(const core::Vec3& centre, double radius, double skin, std::vector<int>& found) const;
    /// Whether a sphere about `centre` may touch `triangle` when it has gone up to `skin` [m].
    [[nodiscard]] bool near(int triangle, const core::Vec3& centre, double radius, double skin) const;
    /// The same for a plain triangle; for others only the heights.
    [[nodiscard]] CentreBounds bounds(int triangle, double radius, double skin) const;
    [[nodiscard]] int material(int triangle) const { return material_.size() == 1 ? material_.front() : material_[std::size_t(triangle)]; }
    /// The curved triangles, for vector code.
    [[nodiscard]] const std::vector<WallPatch>& patches() const { return patches_; }
    /// Whether a triangle has no sharp edge and no sharp corner: it is met only where a foot is inside.
    [[nodiscard]] bool plain(int triangle) const { return triangles_[std::size_t(triangle)].plain; }
    /// Whether a foot on the patch of `triangle` lies outside one of its sharp edges.
    [[nodiscard]] bool beyond_sharp_edge(int triangle, const PatchPlace<double>& foot) const;
    /// Whether the centre faces a sharp edge or corner of `triangle`; each place of contact once, up to rounding.
    /// @param foot  Of the centre on the triangle's patch, outside the triangle.
    [[nodiscard]] bool meet_rim(int triangle, const PatchPlace<double>& foot, const core::Vec3& centre, SurfaceHit& hit) const;

private:
    struct Triangle {
        std::array<core::Vec3, 3> corner;
        double low, high;                      ///< The patch's heights over the flat triangle are within these [m].
        double bulge;                          ///< Greatest distance of the patch from the flat triangle [m].
        std::array<double, 3> room, lean;      ///< A foot inside lies below a centre that is no further outside than room + lean depth.
        std::array<double, 3> slope;           ///< Of the barycentric coordinates [1/m].
        bool plain = true;                     ///< No sharp edge and no sharp corner.
        std::array<bool, 3> sharp{};           ///< Edges opposite to the corners; of a quadrilateral only that of corner 0 is its own.
        std::array<core::Vec3, 3> across;      ///< In the neighbour's plane, away from that edge; zero at the rim of the surface.
        std::array<int, 3> vertex{-1, -1, -1}; ///< Number of the corner if it is sharp, or -1.
    };
    void add_triangles(const WallFaces& faces, int face);
    void add_whole(const WallFaces& faces, int face);
    void add_patch(Triangle& triangle, const std::array<core::Vec3, 3>& normal);
    void fill_bins();
    [[nodiscard]] bool meet_edge(const Triangle& triangle, std::size_t edge, const core::Vec3& centre, SurfaceHit& hit) const;
    [[nodiscard]] bool meet_corner(const Triangle& triangle, std::size_t corner, const core::Vec3& centre, SurfaceHit& hit) const;
    [[nodiscard]] std::array<int, 3> bin(const core::Vec3& x) const;

    bool two_sided_ = false;
    std::vector<Triangle> triangles_;
    std::vector<WallPatch> patches_;
    std::vector<int> material_{0};                // of each triangle, or of all
    std::vector<std::vector<core::Vec3>> spokes_; // directions of the edges from each sharp corner
    core::Vec3 low_ = core::Vec3::Zero(), high_ = core::Vec3::Zero();
    std::array<int, 3> bins_{1, 1, 1};
    double bin_width_ = 1.0;
    std::vector<int> bin_start_, bin_triangle_;
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The metrics of one block, as structures of arrays. Face vectors come from the vertices, so that those of each cell
// sum to zero and a uniform flow stays uniform (NUMERICS A1, free stream).
#include "core/field/field.hpp"
#include "core/grid/multi_block.hpp"

namespace core {

/// Width of the halo in which cell centres are known.
inline constexpr int centre_halo = 3;

/// Arrays over the faces along one axis.
struct FaceMetrics {
    Array3<double> area_x, area_y, area_z; ///< area vector towards increasing index [m2]
    /// Two-point transmissibility |S|^2 / (S . d), over-relaxed; d joins the cell centres, or centre and wall [m].
    Array3<double> transmissibility;
    Array3<double> cross_x, cross_y, cross_z; ///< S - T d: what the two-point part leaves to the cell gradients [m2]
    bool straight = false;                    ///< Everywhere nothing: d is normal to the faces.
    Array3<double> inverse_square;            ///< 1 / |d|^2, d between the cell centres on both sides, mirrored beyond boundaries [1/m2]
    Array3<double> weight;                    ///< share of the upper cell in the linear interpolation to the face [-]
};

/// Symmetric 3x3 matrices M of the least-squares gradient: grad q = M sum_f w_f d_f (q_f - q), w_f = 1 / |d_f|^2.
struct GradientMatrices {
    Array3<double> xx, xy, xz, yy, yz, zz;
};

/// A sub-face on a side of the block. Its flux is towards increasing index of the block where the sense is +1.
struct SubFaceMetrics {
    int axis;              ///< of the face it is a piece of
    Index3 face, cell;     ///< that face, and the cell of this block beside it
    int beyond, at_centre; ///< numbers of values that fields keep behind their halo (sub_face_values.hpp)
    bool is_a;             ///< The area vector points out of this block.
    double sense;
    Vec3 area;               ///< from a to b [m2]
    double transmissibility; ///< [m]
    Vec3 cross;              ///< [m2]
    Vec3 from_a, from_b;     ///< from the centres of the cells to its own [m]
    double weight;           ///< share of b in the linear interpolation to it
};

/// A cell beside sub-faces.
struct JoinedCell {
    Index3 cell;
    std::array<bool, 6> joined{}; ///< its faces that are sums of sub-faces
    std::vector<int> sub_faces;   ///< their numbers
};

struct BlockGeometry {
    Extents cells;
    Array3<double> volume;                       ///< [m3]
    Array3<double> centre_x, centre_y, centre_z; ///< halo of centre_halo layers; mirrored beyond walls [m]
    std::array<FaceMetrics, 3> face;
    GradientMatrices gradient;             ///< boundary faces take no part (pressure: no normal gradient is assumed)
    GradientMatrices wall_gradient;        ///< boundary faces take part with their own value (velocity: no slip)
    std::vector<SubFaceMetrics> sub_faces; ///< faces of sides that meet others at sub-faces have the sums of their areas
    std::vector<JoinedCell> joined_cells;  ///< in the order of their first sub-faces
    /// Inverse Jacobian d(xi_m)/d(x_j), [m][j], halo of centre_halo - 1 layers [1/m].
    std::array<std::array<Array3<double>, 3>, 3> inverse_jacobian;
    /// 1 where the six-point stencils reach round a singular edge, else 0.
    Array3<unsigned char> near_singular;

    /// Do fluxes of gradients follow from the two cells beside each face alone?
    [[nodiscard]] bool is_straight() const { return sub_faces.empty() && face[0].straight && face[1].straight && face[2].straight; }
    [[nodiscard]] Vec3 centre(int i, int j, int k) const { return {centre_x(i, j, k), centre_y(i, j, k), centre_z(i, j, k)}; }
    [[nodiscard]] Vec3 area(int axis, int i, int j, int k) const
    {
        const FaceMetrics& f = face[std::size_t(axis)];
        return {f.area_x(i, j, k), f.area_y(i, j, k), f.area_z(i, j, k)};
    }
};

} // namespace core

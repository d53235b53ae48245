// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fluxes through the sub-faces on sides of blocks whose points do not match, summed up to the faces of the block; and factors on them.
// Both blocks find the same numbers for each sub-face to the last bit. Blocks without such sides return at once.
#include "core/grid/geometry.hpp"

namespace physics {

/// Values beside a sub-face: of cell a and of cell b, whichever of them is in this block.
struct SubFacePair {
    double a, b;
};
[[nodiscard]] inline SubFacePair pair_at(const core::SubFaceMetrics& s, core::View<const double> q)
{
    const double here = q[s.cell], beyond = q.behind_halo(s.beyond);
    return s.is_a ? SubFacePair{here, beyond} : SubFacePair{beyond, here};
}

/// Faces of joined sides become the sums of the fluxes through their sub-faces.
void sum_sub_faces(const core::BlockGeometry& geometry, core::FaceView<double> flux);
/// Faces of joined sides become the means of the factors on their sub-faces, as a gradient across them feels them.
void average_sub_faces(const core::BlockGeometry& geometry, core::FaceView<double> factors);

/// Factors on sub-faces, and their means on faces: combine(value of a, value of b, share of b in linear interpolation).
/// @param q  With what lies behind its halo.
template <class Combine>
void combine_at_sub_faces(const core::BlockGeometry& geometry, core::View<const double> q, core::FaceView<double> factors, Combine combine)
{
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) {
        const SubFacePair v = pair_at(geometry.sub_faces[n], q);
        factors.sub_faces(int(n), 0, 0) = combine(v.a, v.b, geometry.sub_faces[n].weight);
    }
    average_sub_faces(geometry, factors);
}

/// Flux of grad q, F = T (q_b - q_a) + (S - T d) . (g_a + g_b) / 2 of each sub-face, as face_flux.hpp has it of faces.
/// @param q          One halo layer, and what lies behind the halo.
/// @param gradients  Of q, the same.
/// @param flux       Sub-faces and faces of joined sides are overwritten.
void sub_face_gradient_flux(const core::BlockGeometry& geometry, core::View<const double> q, core::VectorView<const double> gradients,
                            core::FaceView<double> flux);

/// Flux of a vector, interpolated to the centre of each sub-face.
void sub_face_interpolated_flux(const core::BlockGeometry& geometry, core::VectorView<const double> u, core::FaceView<double> flux);

/// (f - 1) (S . d u / d x_c - S_c div u), f a factor of each sub-face, the gradients the means of those of the cells on both sides.
/// @param gradients  Of the components of u.
void sub_face_transposed_flux(const core::BlockGeometry& geometry, const std::array<core::VectorView<const double>, 3>& gradients, int c,
                              core::FaceView<const double> factors, core::FaceView<double> flux);

/// Flux of a uniform vector times a factor of each sub-face.
void sub_face_uniform_flux(const core::BlockGeometry& geometry, const core::Vec3& vector, core::FaceView<const double> factors,
                           core::FaceView<double> flux);

/// How much a pressure gradient makes of a volume flux, for add_pressure_smoothing() of projection.hpp.
struct SmoothingStrength {
    double mobility;  ///< dt / density [m3 s/kg]
    double diffusion; ///< of the implicit viscosity [m2]
};

/// flux += mobility (S . (g_a + g_b) / 2 - F) of each sub-face.
/// @param compact  F, the compact flux of the pressure.
void smooth_joined_pressure(const core::BlockGeometry& geometry, const SmoothingStrength& strength, core::VectorView<const double> gradient,
                            core::FaceView<const double> compact, core::FaceView<double> flux);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {
namespace {

double mean(SubFacePair p) { return 0.5 * (p.a + p.b); }

core::Vec3 mean_at(const core::SubFaceMetrics& s, core::VectorView<const double> g)
{
    return {mean(pair_at(s, g.x)), mean(pair_at(s, g.y)), mean(pair_at(s, g.z))};
}

/// flux = flux_of(sub-face, its number), and its sums on faces.
template <class FluxOf>
void set_sub_faces(const core::BlockGeometry& geometry, core::FaceView<double> flux, FluxOf flux_of)
{
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) flux.sub_faces(int(n), 0, 0) = flux_of(geometry.sub_faces[n], int(n));
    sum_sub_faces(geometry, flux);
}

} // namespace

void sum_sub_faces(const core::BlockGeometry& geometry, core::FaceView<double> flux)
{
    const auto& all = geometry.sub_faces;
    for (const core::SubFaceMetrics& s : all) flux.along(s.axis)[s.face] = 0;
    for (std::size_t n = 0; n < all.size(); ++n) flux.along(all[n].axis)[all[n].face] += all[n].sense * flux.sub_faces(int(n), 0, 0);
}

void average_sub_faces(const core::BlockGeometry& geometry, core::FaceView<double> factors)
{
    const auto& all = geometry.sub_faces;
    for (const core::SubFaceMetrics& s : all) factors.along(s.axis)[s.face] = 0;
    for (std::size_t n = 0; n < all.size(); ++n) {
        const double whole = geometry.face[std::size_t(all[n].axis)].transmissibility.view()[all[n].face];
        factors.along(all[n].axis)[all[n].face] += all[n].transmissibility / whole * factors.sub_faces(int(n), 0, 0);
    }
}

void sub_face_gradient_flux(const core::BlockGeometry& geometry, core::View<const double> q, core::VectorView<const double> gradients,
                            core::FaceView<double> flux)
{
    set_sub_faces(geometry, flux, [&](const core::SubFaceMetrics& s, int) {
        const SubFacePair v = pair_at(s, q);
        return s.transmissibility * (v.b - v.a) + s.cross.dot(mean_at(s, gradients));
    });
}

void sub_face_interpolated_flux(const core::BlockGeometry& geometry, core::VectorView<const double> u, core::FaceView<double> flux)
{
    set_sub_faces(geometry, flux, [&](const core::SubFaceMetrics& s, int) {
        return s.area.x() * u.x.behind_halo(s.at_centre) + s.area.y() * u.y.behind_halo(s.at_centre) +
               s.area.z() * u.z.behind_halo(s.at_centre);
    });
}

void sub_face_transposed_flux(const core::BlockGeometry& geometry, const std::array<core::VectorView<const double>, 3>& gradients, int c,
                              core::FaceView<const double> factors, core::FaceView<double> flux)
{
    const auto& [x, y, z] = gradients;
    set_sub_faces(geometry, flux, [&](const core::SubFaceMetrics& s, int n) {
        const core::Vec3 change = mean_at(s, {x.component(c), y.component(c), z.component(c)});
        return (factors.sub_faces(n, 0, 0) - 1) * (s.area.dot(change) - s.area[c] * mean_at(s, {x.x, y.y, z.z}).sum());
    });
}

void sub_face_uniform_flux(const core::BlockGeometry& geometry, const core::Vec3& vector, core::FaceView<const double> factors,
                           core::FaceView<double> flux)
{
    set_sub_faces(geometry, flux, [&](const core::SubFaceMetrics& s, int n) { return factors.sub_faces(n, 0, 0) * s.area.dot(vector); });
}

void smooth_joined_pressure(const core::BlockGeometry& geometry, const SmoothingStrength& strength, core::VectorView<const double> gradient,
                            core::FaceView<const double> compact, core::FaceView<double> flux)
{
    set_sub_faces(geometry, flux, [&](const core::SubFaceMetrics& s, int n) {
        const double t = s.transmissibility;
        const double diagonal = 1 + 6 * strength.diffusion * t * t / s.area.squaredNorm();
        const double smoothing = s.area.dot(mean_at(s, gradient)) - compact.sub_faces(n, 0, 0);
        return flux.sub_faces(n, 0, 0) + strength.mobility / diagonal * smoothing;
    });
}

} // namespace physics

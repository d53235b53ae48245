// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {
namespace {

/// A value beside a sub-face: of cell a and of cell b, whichever of them is in this block.
struct Pair {
    double a, b;
};

Pair pair_at(const core::SubFaceMetrics& s, core::View<const double> q)
{
    const double here = q[s.cell], beyond = q.behind_halo(s.beyond);
    return s.is_a ? Pair{here, beyond} : Pair{beyond, here};
}

double mean(Pair p) { return 0.5 * (p.a + p.b); }

core::Vec3 mean_at(const core::SubFaceMetrics& s, core::VectorView<const double> g)
{
    return {mean(pair_at(s, g.x)), mean(pair_at(s, g.y)), mean(pair_at(s, g.z))};
}

double gradient_flux_of(const core::SubFaceMetrics& s, core::View<const double> q, core::VectorView<const double> g)
{
    const Pair v = pair_at(s, q);
    return s.transmissibility * (v.b - v.a) + s.cross.dot(mean_at(s, g));
}

/// flux of each face = sum of flux_of(sub-face).
template <class FluxOf>
void sum_up(const core::BlockGeometry& geometry, core::FaceView<double> flux, FluxOf flux_of)
{
    for (const core::SubFaceMetrics& s : geometry.sub_faces) flux.along(s.axis)[s.face] = 0;
    for (const core::SubFaceMetrics& s : geometry.sub_faces) flux.along(s.axis)[s.face] += s.sense * flux_of(s);
}

} // namespace

void sub_face_gradient_flux(const core::BlockGeometry& geometry, core::View<const double> q, core::VectorView<const double> gradients,
                            core::FaceView<double> flux)
{
    sum_up(geometry, flux, [&](const core::SubFaceMetrics& s) { return gradient_flux_of(s, q, gradients); });
}

void sub_face_interpolated_flux(const core::BlockGeometry& geometry, core::VectorView<const double> u, core::FaceView<double> flux)
{
    sum_up(geometry, flux, [&](const core::SubFaceMetrics& s) {
        return s.area.x() * u.x.behind_halo(s.at_centre) + s.area.y() * u.y.behind_halo(s.at_centre) +
               s.area.z() * u.z.behind_halo(s.at_centre);
    });
}

void set_joined_aside(const core::BlockGeometry& geometry, core::FaceView<double> scratch, core::FaceView<const double> flux)
{
    for (const core::SubFaceMetrics& s : geometry.sub_faces) scratch.along(s.axis)[s.face] = flux.along(s.axis)[s.face];
}

void smooth_joined_pressure(const core::BlockGeometry& geometry, const SmoothingStrength& strength, core::View<const double> pressure,
                            core::VectorView<const double> gradient, core::FaceView<const double> aside, core::FaceView<double> flux)
{
    for (const core::SubFaceMetrics& s : geometry.sub_faces) flux.along(s.axis)[s.face] = aside.along(s.axis)[s.face];
    for (const core::SubFaceMetrics& s : geometry.sub_faces) {
        const double t = s.transmissibility;
        const double diagonal = 1 + 6 * strength.diffusion * t * t / s.area.squaredNorm();
        const double smoothing = s.area.dot(mean_at(s, gradient)) - gradient_flux_of(s, pressure, gradient);
        flux.along(s.axis)[s.face] += s.sense * (strength.mobility / diagonal * smoothing);
    }
}

} // namespace physics

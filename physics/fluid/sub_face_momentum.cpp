// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/sub_face_momentum.hpp"

namespace physics {
namespace {

core::Vec3 at_centre(const core::SubFaceMetrics& s, core::VectorView<const double> q)
{
    return {q.x.behind_halo(s.at_centre), q.y.behind_halo(s.at_centre), q.z.behind_halo(s.at_centre)};
}

/// Of the cells on both sides.
core::Vec3 mean_at(const core::SubFaceMetrics& s, core::VectorView<const double> q)
{
    const auto mean = [&](core::View<const double> v) { return 0.5 * (v[s.cell] + v.behind_halo(s.beyond)); };
    return {mean(q.x), mean(q.y), mean(q.z)};
}

void add(core::VectorView<double> q, core::Index3 cell, const core::Vec3& more)
{
    for (int c = 0; c < 3; ++c) q.component(c)[cell] += more[c];
}

} // namespace

void flux_beyond_interpolated(const core::BlockGeometry& geometry, core::FaceView<const double> flux, core::VectorView<const double> middle,
                              core::VectorView<double> miss)
{
    for (const core::SubFaceMetrics& s : geometry.sub_faces)
        for (int c = 0; c < 3; ++c) miss.component(c)[s.cell] = 0;
    for (const core::SubFaceMetrics& s : geometry.sub_faces) {
        const core::Vec3 face = geometry.area(s.axis, s.face.i, s.face.j, s.face.k), part = s.sense * s.area;
        const double square = face.squaredNorm();
        const double beyond = flux.along(s.axis)[s.face] * part.dot(face) / square - part.dot(at_centre(s, middle));
        add(miss, s.cell, beyond / square * face);
    }
}

void close_joined(const core::BlockGeometry& geometry, core::FaceView<double> flux)
{
    for (const core::SubFaceMetrics& s : geometry.sub_faces) flux.along(s.axis)[s.face] = 0;
}

void carry_through_sub_faces(const core::BlockGeometry& geometry, double dt, core::VectorView<const double> middle,
                             core::VectorView<const double> miss, core::VectorView<double> velocity)
{
    const auto volume = geometry.volume.view();
    for (const core::SubFaceMetrics& s : geometry.sub_faces) {
        const core::Vec3 u = at_centre(s, middle);
        const double flux = s.area.dot(u + mean_at(s, miss));
        add(velocity, s.cell, (s.is_a ? -dt : dt) * flux / volume[s.cell] * u);
    }
}

} // namespace physics

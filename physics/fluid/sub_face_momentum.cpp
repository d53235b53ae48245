// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/sub_face_momentum.hpp"

namespace physics {

void close_joined(const core::BlockGeometry& geometry, core::FaceView<double> flux)
{
    for (const core::SubFaceMetrics& s : geometry.sub_faces) flux.along(s.axis)[s.face] = 0;
}

void carry_through_sub_faces(const core::BlockGeometry& geometry, double dt, core::FaceView<const double> flux,
                             core::VectorView<const double> middle, core::VectorView<double> velocity)
{
    const auto volume = geometry.volume.view();
    for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n) {
        const core::SubFaceMetrics& s = geometry.sub_faces[n];
        const double share = (s.is_a ? -dt : dt) * flux.sub_faces(int(n), 0, 0) / volume[s.cell];
        for (int c = 0; c < 3; ++c) velocity.component(c)[s.cell] += share * middle.component(c).behind_halo(s.at_centre);
    }
}

} // namespace physics

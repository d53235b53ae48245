// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The axes of a picture of a scene: the long axis of the domain from left to right, gravity down, the third towards the eye.
#include "io/picture/picture.hpp"
#include "io/scene/scene.hpp"

namespace io {

struct PictureFrame {
    core::Mat3 axes = core::Mat3::Identity(); ///< rows: right, up, towards the eye, in the user's coordinates

    [[nodiscard]] std::array<float, 3> operator()(const core::Vec3& x) const
    {
        const core::Vec3 seen = axes * x;
        return {float(seen.x()), float(seen.y()), float(seen.z())};
    }
};

[[nodiscard]] PictureFrame picture_frame(const Scene& scene);

/// Looks at the domain obliquely from its side and from a little above, as figures of textbooks do.
[[nodiscard]] Camera side_camera(const Scene& scene, const PictureFrame& frame, double aspect);

} // namespace io

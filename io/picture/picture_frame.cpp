// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_frame.hpp"

namespace io {

PictureFrame picture_frame(const Scene& scene)
{
    const core::Vec3 size = scene.grid.high() - scene.grid.low();
    int along = 0;
    core::Vec3 up = core::Vec3::UnitY();
    if (scene.gravity) {
        up = -scene.gravity->direction.normalized();
    } else {
        size.maxCoeff(&along);
        if (along == 1) up = core::Vec3::UnitZ();
    }
    (size.array() * (1.0 - up.array().abs())).maxCoeff(&along); // the longest that gravity does not point along
    const core::Vec3 right = (core::Vec3::Unit(along) - up[along] * up).normalized();
    PictureFrame frame;
    frame.axes.row(0) = right.transpose();
    frame.axes.row(1) = up.transpose();
    frame.axes.row(2) = right.cross(up).transpose();
    return frame;
}

Camera side_camera(const Scene& scene, const PictureFrame& frame, double aspect)
{
    const core::Vec3 low = scene.grid.low(), high = scene.grid.high();
    const core::Vec3 middle = frame.axes * (0.5 * (low + high));
    const core::Vec3 half = frame.axes.cwiseAbs() * (0.5 * (high - low));
    return fit_camera(middle - half, middle + half, {-0.36, -0.25, -0.90}, aspect);
}

} // namespace io

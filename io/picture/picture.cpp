// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture.hpp"

#include <cmath>
#include <numbers>

namespace io {

Camera fit_camera(const core::Vec3& low, const core::Vec3& high, const core::Vec3& direction, double aspect)
{
    Camera camera;
    const core::Vec3 ahead = direction.normalized();
    camera.target = 0.5 * (low + high);
    if (std::abs(ahead.dot(camera.up)) > 0.99) camera.up = core::Vec3::UnitZ();
    const core::Vec3 right = ahead.cross(camera.up).normalized(), up = right.cross(ahead);
    const double tangent_y = std::tan(camera.angle * std::numbers::pi / 360.0), tangent_x = aspect * tangent_y;
    constexpr double margin = 1.05; // leaves room for caption and legend
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const core::Vec3 point(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(), corner & 4 ? high.z() : low.z());
        const core::Vec3 arm = point - camera.target;
        const double across = std::max(std::abs(arm.dot(right)) / tangent_x, std::abs(arm.dot(up)) / tangent_y);
        distance = std::max(distance, margin * across - arm.dot(ahead));
    }
    camera.eye = camera.target - distance * ahead;
    return camera;
}

} // namespace io

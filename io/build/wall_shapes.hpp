// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The triangles of walls that have ends.
#include "core/base/vec3.hpp"
#include "io/scene/wall_keys.hpp"
#include <array>
#include <vector>

namespace io {

/// In the user's coordinates [m]; none for planes and cylinders, which are endless.
/// @throws core::ConfigError for a file that cannot be read.
[[nodiscard]] std::vector<std::array<core::Vec3, 3>> triangles_of(const WallKeys& wall);

/// Triangles that meet at a smaller angle are one round surface [rad].
[[nodiscard]] double smooth_angle_of(const WallKeys& wall);

/// A point of the wall, about which moments are taken if it does not turn [m].
[[nodiscard]] core::Vec3 point_of(const WallKeys& wall);

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a velocity is distributed over a boundary that fluid enters through: laminar, or interpolated between given points.
#include "core/grid/mesh.hpp"
#include <functional>
#include <string>
#include <vector>

namespace physics {

/// Shape of laminar flow through a boundary, its mean over the faces 1: 1 - (1 - d / R)^2, d the distance from the nearest wall at the
/// edge of the boundary and R the largest. Exact between plates, in round pipes and below a symmetry plane; an approximation elsewhere.
/// @param is_wall  Does the boundary of this name hold the fluid?
/// @throws core::ConfigError if no wall meets the boundary.
[[nodiscard]] std::function<double(const core::Vec3&)> laminar_shape(const core::Mesh& mesh, const std::string& boundary,
                                                                     const std::function<bool(const std::string&)>& is_wall);

/// A velocity known at a place.
struct VelocityPoint {
    core::Vec3 place;    ///< [m]
    core::Vec3 velocity; ///< [m/s]
};

/// Velocity between scattered points: the linear function that fits the nearest eight best, weighted by 1 / distance^2. Exact for
/// velocities that are linear in space, and at the points.
/// @throws core::ConfigError without points.
[[nodiscard]] std::function<core::Vec3(const core::Vec3&)> interpolated_velocity(std::vector<VelocityPoint> points);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What drives the water through periodic ends: a mean pressure gradient, given as an acceleration.
#include "core/base/vec3.hpp"
#include <variant>

namespace physics {

struct ConstantDrive {
    core::Vec3 acceleration = core::Vec3::Zero(); ///< -(1/rho) mean pressure gradient [m/s2]
};

/// acceleration = amplitude cos(angular_frequency t + phase)
struct HarmonicDrive {
    core::Vec3 amplitude;     ///< [m/s2]
    double angular_frequency; ///< [rad/s], not zero
    double phase = 0;         ///< [rad]
};

/// Turns round whenever the speed on the axis, in the direction of the drive, reaches a value.
struct ReversingDrive {
    core::Vec3 acceleration; ///< first direction [m/s2]
    double axis_speed;       ///< [m/s]
};

using Drive = std::variant<ConstantDrive, HarmonicDrive, ReversingDrive>;

/// What a drive remembers from step to step.
struct DriveState {
    double sign = 1;
    double switched_at = 0; ///< [s]
};

/// Mean acceleration over [time, time + dt], exact: the drive's impulse over the step divided by dt [m/s2].
[[nodiscard]] core::Vec3 mean_acceleration(const Drive& drive, const DriveState& state, double time, double dt);

/// Unit vector of the drive; zero if there is none.
[[nodiscard]] core::Vec3 drive_direction(const Drive& drive);

/// Turns a reversing drive round if the speed on the axis asks for it.
/// @param axis_speed  Velocity on the axis along drive_direction() [m/s].
/// @return did it turn?
[[nodiscard]] bool turn_if_due(const Drive& drive, double axis_speed, double time, DriveState& state);

} // namespace physics

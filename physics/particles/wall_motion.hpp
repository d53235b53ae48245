// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a wall moves: along a line, about an axis, to and fro. Where it is follows from the time alone.
#include "core/base/vec3.hpp"

#include <limits>

namespace physics {

/// Where a wall is at one time, and how fast each of its points moves.
struct WallPose {
    core::Mat3 turn = core::Mat3::Identity();   ///< From the wall's own frame, which is where it is at t = 0.
    core::Vec3 shift = core::Vec3::Zero();      ///< [m]
    core::Vec3 axis_point = core::Vec3::Zero(); ///< On the axis that it turns about [m].
    core::Vec3 velocity = core::Vec3::Zero();   ///< Of that point [m/s].
    core::Vec3 spin = core::Vec3::Zero();       ///< [rad/s]

    /// Where a point of the wall's own frame is [m].
    [[nodiscard]] core::Vec3 place(const core::Vec3& own) const { return turn * own + shift; }
    /// The inverse of place().
    [[nodiscard]] core::Vec3 own(const core::Vec3& x) const { return turn.transpose() * (x - shift); }
    [[nodiscard]] core::Vec3 velocity_at(const core::Vec3& x) const { return velocity + spin.cross(x - axis_point); }
};

/// From `start` to `stop` it does all three at once; before and after it stands still. The axis goes along with the wall.
struct WallMotion {
    core::Vec3 velocity = core::Vec3::Zero();         ///< [m/s]
    core::Vec3 axis_point = core::Vec3::Zero();       ///< On the axis at the start [m].
    core::Vec3 angular_velocity = core::Vec3::Zero(); ///< Along the axis [rad/s].
    core::Vec3 amplitude = core::Vec3::Zero();        ///< Of amplitude (sin(frequency t + phase) - sin(phase)) [m].
    double angular_frequency = 0.0;                   ///< [rad/s]
    double phase = 0.0;                               ///< [rad]
    double start = 0.0;                               ///< [s]
    double stop = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool moves() const;
    [[nodiscard]] WallPose at(double time) const;
    /// Most that any of its points moves in a time [m/s]. @param reach  Distance of points from the axis, at most [m].
    [[nodiscard]] double largest_speed(double reach) const;
};

/// An upper bound for how far points of a wall have gone from one pose to the other [m].
/// @param low,high  A box that holds the points when they are at `from` [m].
[[nodiscard]] double way_between(const WallPose& from, const WallPose& to, const core::Vec3& low, const core::Vec3& high);

} // namespace physics

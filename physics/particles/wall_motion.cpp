// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace physics {

using core::Mat3, core::Vec3;

bool WallMotion::moves() const
{
    const bool sways = angular_frequency != 0.0 && !amplitude.isZero(0.0);
    return (sways || !velocity.isZero(0.0) || !angular_velocity.isZero(0.0)) && stop > start;
}

WallPose WallMotion::at(double time) const
{
    const double gone = std::clamp(time, start, stop) - start;
    const double angle = angular_frequency * gone + phase, rate = angular_velocity.norm();
    WallPose pose;
    const Vec3 offset = gone * velocity + (std::sin(angle) - std::sin(phase)) * amplitude;
    if (rate > 0.0) pose.turn = Eigen::AngleAxisd(std::fmod(rate * gone, 2 * std::numbers::pi), angular_velocity / rate).toRotationMatrix();
    pose.axis_point = axis_point + offset;
    pose.shift = pose.axis_point - pose.turn * axis_point;
    if (time < start || time >= stop) return pose;
    pose.velocity = velocity + angular_frequency * std::cos(angle) * amplitude;
    pose.spin = angular_velocity;
    return pose;
}

double WallMotion::largest_speed(double reach) const
{
    return velocity.norm() + std::abs(angular_frequency) * amplitude.norm() + angular_velocity.norm() * reach;
}

double way_between(const WallPose& from, const WallPose& to, const Vec3& low, const Vec3& high)
{
    const Mat3 turned = to.turn * from.turn.transpose() - Mat3::Identity();
    const double chord = turned.norm() / std::numbers::sqrt2; // 2 sin of half the angle: the way of a point at distance 1 from the axis
    const Vec3 along = to.spin.isZero(0.0) ? from.spin : to.spin;
    double reach = 0.0;
    if (chord > 0.0)
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 x(corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]);
            const Vec3 arm = x - from.axis_point;
            reach = std::max(reach, along.isZero(0.0) ? arm.norm() : along.normalized().cross(arm).norm());
        }
    return (to.axis_point - from.axis_point).norm() + chord * reach;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/drive.hpp"
#include "core/base/overloaded.hpp"
#include <cmath>

namespace physics {

core::Vec3 expected_acceleration(const Drive& drive, const DriveState& state, double time, double dt)
{
    return std::visit(core::Overloaded{
                          [](const ConstantDrive& d) -> core::Vec3 { return d.acceleration; },
                          [&](const VaryingDrive& d) -> core::Vec3 { return d.acceleration * mean_value(d.course, time, dt); },
                          [&](const ReversingDrive& d) -> core::Vec3 { return state.sign * d.acceleration; },
                          [&](const FlowDrive& d) -> core::Vec3 { return state.expected * d.direction; },
                      },
                      drive);
}

core::Vec3 mean_acceleration(const Drive& drive, const DriveState& state, double time, double dt)
{
    const core::Vec3 expected = expected_acceleration(drive, state, time, dt);
    const auto* flow = std::get_if<FlowDrive>(&drive);
    return flow ? core::Vec3(expected + state.correction * flow->direction) : expected;
}

core::Vec3 drive_direction(const Drive& drive)
{
    const core::Vec3 a = std::visit(core::Overloaded{
                                        [](const ConstantDrive& d) { return d.acceleration; },
                                        [](const VaryingDrive& d) { return d.acceleration; },
                                        [](const ReversingDrive& d) { return d.acceleration; },
                                        [](const FlowDrive& d) { return d.direction; },
                                    },
                                    drive);
    return a.isZero() ? a : a.normalized();
}

double drive_strength(const Drive& drive, const DriveState& state)
{
    return std::visit(core::Overloaded{
                          [](const ConstantDrive& d) { return d.acceleration.norm(); },
                          [](const VaryingDrive& d) { return d.acceleration.norm() * largest_magnitude(d.course); },
                          [](const ReversingDrive& d) { return d.acceleration.norm(); },
                          [&](const FlowDrive&) { return std::abs(state.resistance); },
                      },
                      drive);
}

bool turn_if_due(const Drive& drive, double axis_speed, double time, DriveState& state)
{
    const auto* reversing = std::get_if<ReversingDrive>(&drive);
    if (!reversing || state.sign * axis_speed < reversing->axis_speed) return false;
    state.sign = -state.sign;
    state.switched_at = time;
    return true;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/drive.hpp"

#include <cmath>

namespace physics {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};

} // namespace

core::Vec3 mean_acceleration(const Drive& drive, const DriveState& state, double time, double dt)
{
    return std::visit(Overloaded{
                          [](const ConstantDrive& d) -> core::Vec3 { return d.acceleration; },
                          [&](const HarmonicDrive& d) -> core::Vec3 {
                              // Mean of a cosine: its value at mid-step times sin(h) / h, h half the phase of the step.
                              const double half = 0.5 * d.angular_frequency * dt;
                              const double middle = std::cos(d.angular_frequency * time + half + d.phase);
                              return d.amplitude * (middle * (half == 0 ? 1 : std::sin(half) / half));
                          },
                          [&](const ReversingDrive& d) -> core::Vec3 { return state.sign * d.acceleration; },
                      },
                      drive);
}

core::Vec3 drive_direction(const Drive& drive)
{
    const core::Vec3 a = std::visit(Overloaded{
                                        [](const ConstantDrive& d) { return d.acceleration; },
                                        [](const HarmonicDrive& d) { return d.amplitude; },
                                        [](const ReversingDrive& d) { return d.acceleration; },
                                    },
                                    drive);
    return a.isZero() ? a : a.normalized();
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

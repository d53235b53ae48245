// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What drives the water through periodic ends: a mean pressure gradient, given as an acceleration, or the flow that it must make.
#include "core/base/vec3.hpp"
#include "physics/fluid/time_course.hpp"
#include <variant>

namespace physics {

struct ConstantDrive {
    core::Vec3 acceleration = core::Vec3::Zero(); ///< -(1/rho) mean pressure gradient [m/s2]
};

/// acceleration * course(t)
struct VaryingDrive {
    core::Vec3 acceleration; ///< [m/s2]
    TimeCourse course;
};

/// acceleration = amplitude cos(angular_frequency t + phase)
[[nodiscard]] inline VaryingDrive harmonic_drive(const core::Vec3& amplitude, double angular_frequency, double phase = 0)
{
    return {amplitude, HarmonicCourse{0, 1, angular_frequency, phase}};
}

/// Turns round whenever the speed on the axis, in the direction of the drive, reaches a value.
struct ReversingDrive {
    core::Vec3 acceleration; ///< first direction [m/s2]
    double axis_speed;       ///< [m/s]
};

/// At the end of every step flow * course(t) goes through each section across the direction, fluid and grains together; each step
/// finds the mean acceleration that does it (steps/flow_control.hpp).
struct FlowDrive {
    enum class Measure { flow_rate, bulk_velocity };
    core::Vec3 direction; ///< of unit length
    double flow;          ///< [m3/s], or over the mean area of sections [m/s]
    TimeCourse course = SteadyCourse{};
    Measure measure = Measure::flow_rate;
    /// @param area  Mean area of sections [m2].
    /// @return [m3/s]
    [[nodiscard]] double target(double time, double area) const
    {
        return flow * value_at(course, time) * (measure == Measure::bulk_velocity ? area : 1.0);
    }
};

using Drive = std::variant<ConstantDrive, VaryingDrive, ReversingDrive, FlowDrive>;

/// What a drive remembers from step to step, and what has been found of the present one.
struct DriveState {
    double sign = 1;
    double switched_at = 0; ///< [s]
    // Of a prescribed flow:
    double expected = 0;   ///< acceleration that the step begins with and grains are told [m/s2]
    double correction = 0; ///< what has to be added to it [m/s2]
    double resistance = 0; ///< acceleration of the last step beyond what changed the flow: it holds the flow against friction [m/s2]
    double flow = 0;       ///< at the start of the step [m3/s]
};

/// Mean acceleration over [time, time + dt] as it is known when the step begins, exact: the drive's impulse over dt [m/s2].
[[nodiscard]] core::Vec3 expected_acceleration(const Drive& drive, const DriveState& state, double time, double dt);
/// What acted in the end: of a prescribed flow, with what the step has found.
[[nodiscard]] core::Vec3 mean_acceleration(const Drive& drive, const DriveState& state, double time, double dt);

/// Unit vector of the drive; zero if there is none.
[[nodiscard]] core::Vec3 drive_direction(const Drive& drive);

/// Largest acceleration that the drive gives at any time; of a prescribed flow, what held it in the last step [m/s2].
[[nodiscard]] double drive_strength(const Drive& drive, const DriveState& state);

/// Turns a reversing drive round if the speed on the axis asks for it.
/// @param axis_speed  Velocity on the axis along drive_direction() [m/s].
/// @return did it turn?
[[nodiscard]] bool turn_if_due(const Drive& drive, double axis_speed, double time, DriveState& state);

} // namespace physics

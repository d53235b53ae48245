// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Walls of their own, beside those of the grid, and how they move, as the user describes them.
#include "core/base/vec3.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;

enum class WallSide { inside, outside };
inline constexpr std::array<std::string_view, 2> wall_side_words{"inside", "outside"};

struct PlaneKeys {
    core::Vec3 point = core::Vec3::Zero(), normal = core::Vec3::UnitZ(); ///< [m], [-]
    bool operator==(const PlaneKeys&) const = default;
};

struct CylinderWallKeys {
    core::Vec3 point = core::Vec3::Zero(), axis = core::Vec3::UnitX(); ///< [m], [-]
    double radius = 0.0;                                               ///< [m]
    WallSide particles = WallSide::inside;
    bool operator==(const CylinderWallKeys&) const = default;
};

/// A cylinder or cone between two points.
struct TubeKeys {
    core::Vec3 from = core::Vec3::Zero(), to = core::Vec3::Zero(); ///< Ends of the axis [m].
    double radius = 0.0;                                           ///< [m]
    std::optional<double> end_radius;                              ///< at `to`; without it, that at `from` [m]
    bool operator==(const TubeKeys&) const = default;
};

struct DiscKeys {
    core::Vec3 point = core::Vec3::Zero(), normal = core::Vec3::UnitZ(); ///< Its middle [m], [-].
    double radius = 0.0, hole = 0.0;                                     ///< [m]
    bool operator==(const DiscKeys&) const = default;
};

struct StlKeys {
    std::string file;                          ///< relative to the scene's folder
    double unit = 1.0;                         ///< what 1 in the file means [m]
    core::Vec3 at = core::Vec3::Zero();        ///< where its origin lies [m]
    double smooth_angle = 0.26179938779914943; ///< 15 degrees [rad]
    std::optional<WallSide> particles;         ///< of a closed surface; without it on both
    bool operator==(const StlKeys&) const = default;
};

struct RotationKeys {
    core::Vec3 point = core::Vec3::Zero(), axis = core::Vec3::UnitX(); ///< [m], [-]
    double rate = 0.0;                                                 ///< [rad/s]
    bool operator==(const RotationKeys&) const = default;
};

struct OscillationKeys {
    core::Vec3 amplitude = core::Vec3::Zero(); ///< [m]
    double frequency = 0.0;                    ///< [Hz]
    double phase = 0.0;                        ///< [rad]
    bool operator==(const OscillationKeys&) const = default;
};

struct MotionKeys {
    std::optional<core::Vec3> velocity; ///< [m/s]
    std::optional<RotationKeys> rotation;
    std::optional<OscillationKeys> oscillation;
    double start = 0.0;         ///< [s]
    std::optional<double> stop; ///< [s]
    bool operator==(const MotionKeys&) const = default;
};

/// Exactly one of the shapes is given.
struct WallKeys {
    std::string name;
    std::string material; ///< Empty: that of walls.
    std::optional<PlaneKeys> plane;
    std::optional<CylinderWallKeys> cylinder;
    std::optional<TubeKeys> tube;
    std::optional<DiscKeys> disc;
    std::optional<StlKeys> stl;
    std::optional<MotionKeys> motion;
    bool operator==(const WallKeys&) const = default;
};

void describe(Schema& s, WallKeys& p);

} // namespace io

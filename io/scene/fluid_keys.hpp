// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fluid of a scene, its boundaries and what drives it, as the user describes them.
#include "io/scene/course_keys.hpp"
#include "io/scene/grid_keys.hpp"
#include "physics/fluid/advection_scheme.hpp"
#include "physics/fluid/boundary_kind.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;

// Enumerations stand with their words, in the same order.

using physics::AdvectionScheme, physics::BoundaryKind;
inline constexpr std::array<std::string_view, 3> advection_scheme_words{"lcsi", "lcsi_spline", "finite_volume"};
inline constexpr std::array<std::string_view, 6> boundary_kind_words{"wall", "slip", "symmetry", "inflow", "outflow", "pressure"};

/// The driving gradient changes sign whenever the speed on the axis reaches this bound.
struct ReverseAt {
    double axis_speed = 0.0; ///< [m/s]
    bool operator==(const ReverseAt&) const = default;
};

/// What drives the fluid along a periodic axis: exactly one of a mean pressure gradient and of what shall flow; constant, times
/// cos(2 pi frequency t), over time as given, or a gradient that reverses. Positive means towards the high end.
struct Drive {
    std::optional<double> pressure_gradient; ///< [Pa/m]
    Axis axis = Axis::x;
    std::optional<double> frequency; ///< [Hz]
    std::optional<ReverseAt> reverse_at;
    std::optional<double> flow_rate;     ///< of fluid and particles through each section [m3/s]
    std::optional<double> bulk_velocity; ///< the same over the mean area of sections [m/s]
    std::optional<CourseKeys> over_time;
    bool operator==(const Drive&) const = default;
};

struct Material {
    std::string name;
    double density = 0.0;   ///< [kg/m3]
    double viscosity = 0.0; ///< kinematic [m2/s]
    bool operator==(const Material&) const = default;
};

enum class InflowProfile { uniform, laminar };
inline constexpr std::array<std::string_view, 2> inflow_profile_words{"uniform", "laminar"};

/// How a wall turns in itself, by the right-hand rule.
struct SpinKeys {
    core::Vec3 axis = core::Vec3::UnitX(), point = core::Vec3::Zero(); ///< [-], [m]
    double rate = 0.0;                                                 ///< [rad/s]
    bool operator==(const SpinKeys&) const = default;

    [[nodiscard]] core::Vec3 velocity(const core::Vec3& x) const { return rate * axis.cross(x - point); }
};

/// What holds on one boundary of the grid.
struct Boundary {
    std::string at; ///< Name of the boundary.
    BoundaryKind kind = BoundaryKind::wall;
    std::optional<core::Vec3> velocity;   ///< Of a wall that moves, or of what flows in [m/s].
    std::optional<double> pressure;       ///< Where it is given; 0 without it [Pa].
    std::optional<InflowProfile> profile; ///< Of an inflow whose mean is `velocity`; uniform without it.
    std::string profile_file;             ///< Points instead of `velocity`; absolute once the scene is read.
    std::optional<SpinKeys> spin;         ///< Of a wall that turns.
    std::optional<CourseKeys> over_time;
    bool operator==(const Boundary&) const = default;
};

/// What a scalar is in the fluid that enters through a boundary.
struct ScalarEntry {
    std::string at; ///< Name of the boundary.
    double value = 0.0;
    bool operator==(const ScalarEntry&) const = default;
};

/// Something that the fluid carries and that does not change it.
struct Scalar {
    std::string name;
    double diffusivity = 0.0; ///< [m2/s]
    double initial = 0.0;
    std::vector<ScalarEntry> entering;
    bool operator==(const Scalar&) const = default;
};

enum class TurbulenceModel { none, k_epsilon, abe_kondoh_nagano };
inline constexpr std::array<std::string_view, 3> turbulence_model_words{"none", "k-epsilon", "abe-kondoh-nagano"};

/// Turbulence that is not resolved.
struct TurbulenceKeys {
    TurbulenceModel model = TurbulenceModel::none;
    double intensity = 0.05;      ///< Root mean square of the fluctuations over the speed, at the start and where fluid flows in.
    std::optional<double> speed;  ///< Of the flow at the start [m/s]; without it, that of what flows in.
    std::optional<double> length; ///< Mixing length there [m]; without it, 7 % of the width between boundaries.
    double roughness = 0.0;       ///< Of walls seen through functions, as height of sand grains [m].
    bool operator==(const TurbulenceKeys&) const = default;
};

struct Fluid {
    Material material;
    AdvectionScheme advection = AdvectionScheme::lcsi;
    std::vector<Boundary> boundaries; ///< Those that are not walls at rest.
    std::optional<Drive> drive;
    std::vector<Scalar> scalars;
    std::optional<TurbulenceKeys> turbulence;
    bool operator==(const Fluid&) const = default;

    [[nodiscard]] bool is_turbulent() const { return turbulence && turbulence->model != TurbulenceModel::none; }
};

void describe(Schema& s, ReverseAt& p);
void describe(Schema& s, Drive& p);
void describe(Schema& s, Material& p);
void describe(Schema& s, SpinKeys& p);
void describe(Schema& s, Boundary& p);
void describe(Schema& s, ScalarEntry& p);
void describe(Schema& s, Scalar& p);
void describe(Schema& s, TurbulenceKeys& p);
void describe(Schema& s, Fluid& p);

} // namespace io

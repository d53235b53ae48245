// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene as the user describes it: plain structs in SI units, with the defaults.
#include "core/base/vec3.hpp"
#include "io/course_keys.hpp"
#include "io/grid_shapes.hpp"
#include "io/value.hpp"
#include "physics/fluid/advection_scheme.hpp"
#include "physics/fluid/boundary_kind.hpp"
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

// Enumerations stand with their words, in the same order.

enum class PipeSize { small, medium, large };
inline constexpr std::array<std::string_view, 3> pipe_size_words{"small", "medium", "large"};

enum class Axis { axial, x, y, z };
inline constexpr std::array<std::string_view, 4> axis_words{"axial", "x", "y", "z"};

using physics::AdvectionScheme, physics::BoundaryKind;
inline constexpr std::array<std::string_view, 3> advection_scheme_words{"lcsi", "lcsi_spline", "finite_volume"};
inline constexpr std::array<std::string_view, 6> boundary_kind_words{"wall", "slip", "symmetry", "inflow", "outflow", "pressure"};

enum class Arrangement { random, lattice, packed };
inline constexpr std::array<std::string_view, 3> arrangement_words{"random", "lattice", "packed"};

enum class ContactLaw { linear };
inline constexpr std::array<std::string_view, 1> contact_law_words{"linear"};

enum class WallShape { faces, primitive };
inline constexpr std::array<std::string_view, 2> wall_shape_words{"faces", "primitive"};

enum class CouplingMode { automatic, pipelined, coarse, concurrent, iterated };
inline constexpr std::array<std::string_view, 5> coupling_mode_words{"auto", "pipelined", "coarse", "concurrent", "iterated"};

enum class DragLaw { smooth, seed };
inline constexpr std::array<std::string_view, 2> drag_law_words{"smooth", "seed"};

enum class MagnusLaw { lun_liu, rubinow_keller, seed };
inline constexpr std::array<std::string_view, 3> magnus_law_words{"lun_liu", "rubinow_keller", "seed"};

enum class CouplingPreset { standard, seed };
inline constexpr std::array<std::string_view, 2> coupling_preset_words{"standard", "seed"};

enum class Switch { automatic, on, off };
inline constexpr std::array<std::string_view, 3> switch_words{"auto", "on", "off"};

/// Cells over the diameter and along the axis. A quarter of `across` lies in each wing of the butterfly, half in its core.
struct PipeCells {
    int across = 16, along = 32;
    bool operator==(const PipeCells&) const = default;

    [[nodiscard]] int core() const { return across / 2; }
    [[nodiscard]] int wing() const { return across / 4; }
    [[nodiscard]] int total() const { return (core() * core() + 4 * core() * wing()) * along; }
};

/// The cells that a named size stands for: 2,160, 6,144 and 20,736.
[[nodiscard]] PipeCells cells_of(PipeSize size);

/// A straight round pipe along x, its axis through the origin of y and z, from x = 0.
struct PipeGrid {
    double diameter = 0.0, length = 0.0; ///< [m]
    std::optional<PipeSize> size;        ///< Medium, unless `cells` are given.
    std::optional<PipeCells> cells;      ///< Instead of a named size.
    int blocks_along = 4;
    double core_fraction = 0.55; ///< Half diagonal of the core over the radius.
    bool operator==(const PipeGrid&) const = default;

    [[nodiscard]] PipeCells chosen_cells() const { return cells ? *cells : cells_of(size.value_or(PipeSize::medium)); }
};

/// A rectangular box with one corner at the origin.
struct BoxGrid {
    core::Vec3 size = core::Vec3::Zero(); ///< [m]
    std::array<int, 3> cells{16, 16, 16};
    std::array<int, 3> blocks{1, 1, 1};
    bool operator==(const BoxGrid&) const = default;
};

/// What a grid fills.
struct GridMeasure {
    core::Vec3 low = core::Vec3::Zero(), high = core::Vec3::Zero(); ///< corners of the box around it [m]
    double volume = 0.0;                                            ///< [m3]
    bool operator==(const GridMeasure&) const = default;
};

/// Exactly one of the shapes is given.
struct Grid {
    std::optional<PipeGrid> pipe;
    std::optional<BoxGrid> box;
    std::optional<WavyBoxGrid> wavy_box;
    std::optional<AnnulusGrid> annulus;
    std::optional<BentPipeGrid> bent_pipe;
    std::optional<SteppedChannelGrid> stepped_channel;
    std::optional<ImportedGrid> blocks;
    std::optional<EllipticKeys> elliptic;
    std::vector<Axis> periodic;         ///< `axial` is the axis of a pipe or annulus, the same as `x`.
    std::optional<GridMeasure> measure; ///< Of shapes other than the pipe and the box, once they have been made.
    bool operator==(const Grid&) const = default;

    [[nodiscard]] bool is_periodic(int axis) const;
    [[nodiscard]] std::array<bool, 3> periodic_axes() const { return {is_periodic(0), is_periodic(1), is_periodic(2)}; }
    /// Is it one whose walls are planes and a cylinder?
    [[nodiscard]] bool is_primitive() const { return pipe || box; }
    /// Must it be made to know what is in it?
    [[nodiscard]] bool is_made() const { return !is_primitive() || elliptic; }
    /// The key of the shape; empty if none is given.
    [[nodiscard]] std::string shape() const;
    /// The box around the domain [m].
    [[nodiscard]] core::Vec3 low() const;
    [[nodiscard]] core::Vec3 high() const;
    [[nodiscard]] double volume() const; ///< [m3]
};

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

/// What holds on one boundary of the grid.
struct Boundary {
    std::string at; ///< Name of the boundary.
    BoundaryKind kind = BoundaryKind::wall;
    std::optional<core::Vec3> velocity;   ///< Of a wall that moves, or of what flows in [m/s].
    std::optional<double> pressure;       ///< Where it is given; 0 without it [Pa].
    std::optional<InflowProfile> profile; ///< Of an inflow whose mean is `velocity`; uniform without it.
    std::string profile_file;             ///< Points instead of `velocity`; absolute once the scene is read.
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

enum class TurbulenceModel { none, k_epsilon };
inline constexpr std::array<std::string_view, 2> turbulence_model_words{"none", "k-epsilon"};

/// Turbulence that is not resolved.
struct TurbulenceKeys {
    TurbulenceModel model = TurbulenceModel::none;
    double intensity = 0.05;      ///< Root mean square of the fluctuations over the speed, at the start and where fluid flows in.
    std::optional<double> speed;  ///< Of the flow at the start [m/s]; without it, that of what flows in.
    std::optional<double> length; ///< Mixing length there [m]; without it, 7 % of the width between boundaries.
    double roughness = 0.0;       ///< of walls, as height of sand grains [m]
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

struct Gravity {
    core::Vec3 direction = -core::Vec3::UnitY();
    double magnitude = 9.81; ///< [m/s2]
    bool operator==(const Gravity&) const = default;
};

/// Where the particles of a species are at the start.
struct Initial {
    Arrangement arrangement = Arrangement::random;
    std::optional<core::Vec3> low, high;      ///< Corners of the region of the centres [m]; the whole domain without them.
    core::Vec3 velocity = core::Vec3::Zero(); ///< [m/s]
    double spacing = 1.0;                     ///< packed: distance of neighbours in diameters; below 1 they press on each other.
    bool operator==(const Initial&) const = default;
};

struct Species {
    std::string name;
    int count = 0;
    double diameter = 0.0; ///< [m]
    double density = 0.0;  ///< [kg/m3]
    Initial initial;
    bool operator==(const Species&) const = default;
};

struct Contact {
    ContactLaw law = ContactLaw::linear;
    double stiffness = 0.0; ///< normal [N/m]
    double restitution = 0.6;
    double friction = 0.4;
    double tangential_ratio = 2.0 / 7.0; ///< tangential over normal stiffness
    int steps_per_contact = 30;
    WallShape walls = WallShape::faces;
    bool operator==(const Contact&) const = default;
};

struct Coupling {
    CouplingMode mode = CouplingMode::automatic;
    Width filter{2.0, true};
    CouplingPreset preset = CouplingPreset::standard;
    std::optional<DragLaw> drag;     ///< Without it, the preset's.
    std::optional<MagnusLaw> magnus; ///< Without it, the preset's.
    Switch added_mass = Switch::automatic, lift = Switch::automatic, torque = Switch::automatic;
    bool operator==(const Coupling&) const = default;

    [[nodiscard]] DragLaw chosen_drag() const;
    [[nodiscard]] MagnusLaw chosen_magnus() const;
};

struct Limits {
    double cfl = 1.0;            ///< Cells crossed by the fluid in a step; of finite volumes, share of a cell that leaves it, at most 1.
    double particle_move = 0.25; ///< Largest move of a particle in a step, in widths of the filter.
    bool operator==(const Limits&) const = default;
};

struct Run {
    double settle = 0.0;             ///< [s] before t = 0, without the drive.
    double until = 0.0;              ///< [s]
    std::optional<double> time_step; ///< [s]; without it, the largest that the limits allow.
    Limits limits;
    int random_seed = 1;
    std::optional<double> wall_clock; ///< [s] of real time, after which the run stops with a checkpoint.
    bool operator==(const Run&) const = default;
};

struct Output {
    Interval results, pictures;
    Interval checkpoint;
    Interval metrics{Interval::Clock::steps, 1.0};
    int keep_checkpoints = 2;
    bool operator==(const Output&) const = default;
};

struct Solver {
    double tolerance = 1e-8; ///< Relative residual of the pressure.
    bool operator==(const Solver&) const = default;
};

struct Scene {
    std::string name;
    Grid grid;
    std::optional<Fluid> fluid;
    std::optional<Gravity> gravity;
    std::vector<Species> particles;
    std::optional<Contact> contact;
    std::optional<Coupling> coupling; ///< Present when there are both fluid and particles.
    Run run;
    Output output;
    Solver solver;
    bool operator==(const Scene&) const = default;

    /// Fills in what other keys decide: the size of a pipe, the coupling of fluid and particles.
    void resolve();
};

} // namespace io

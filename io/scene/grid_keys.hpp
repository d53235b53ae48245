// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The domain of a scene and its cells, as the user describes them.
#include "core/base/vec3.hpp"
#include "io/scene/grid_shapes.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;

// Enumerations stand with their words, in the same order.

enum class PipeSize { small, medium, large };
inline constexpr std::array<std::string_view, 3> pipe_size_words{"small", "medium", "large"};

enum class Axis { axial, x, y, z };
inline constexpr std::array<std::string_view, 4> axis_words{"axial", "x", "y", "z"};

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

/// A turn that carries the domain onto itself, by the right-hand rule.
struct TurnKeys {
    double angle = 0.0;                                                ///< [rad]
    core::Vec3 axis = core::Vec3::UnitX(), point = core::Vec3::Zero(); ///< [-], [m]
    bool operator==(const TurnKeys&) const = default;
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
    std::optional<TurnKeys> turn;       ///< Sides that it lays on each other are joined.
    std::optional<GridMeasure> measure; ///< Of shapes other than the pipe and the box, once they have been made.
    bool operator==(const Grid&) const = default;

    [[nodiscard]] bool is_periodic(int axis) const;
    [[nodiscard]] std::array<bool, 3> periodic_axes() const { return {is_periodic(0), is_periodic(1), is_periodic(2)}; }
    /// Is it one whose walls are planes and a cylinder?
    [[nodiscard]] bool is_primitive() const { return pipe || box; }
    /// Must it be made to know what is in it?
    [[nodiscard]] bool is_made() const { return !is_primitive() || elliptic || turn; }
    /// The key of the shape; empty if none is given.
    [[nodiscard]] std::string shape() const;
    /// The box around the domain [m].
    [[nodiscard]] core::Vec3 low() const;
    [[nodiscard]] core::Vec3 high() const;
    [[nodiscard]] double volume() const; ///< [m3]
};

void describe(Schema& s, PipeCells& p);
void describe(Schema& s, PipeGrid& p);
void describe(Schema& s, BoxGrid& p);
void describe(Schema& s, TurnKeys& p);
void describe(Schema& s, Grid& p);

} // namespace io

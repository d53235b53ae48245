// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The grids of a scene beside the pipe and the box, as the user describes them.
#include "core/base/vec3.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;

/// A box with one corner at the origin, bent to waves.
struct WavyBoxGrid {
    core::Vec3 size = core::Vec3::Zero(); ///< [m]
    std::array<int, 3> cells{16, 16, 16};
    std::array<int, 3> blocks{1, 1, 1};
    double amplitude = 0.0; ///< [m]
    int waves = 1;          ///< along each edge
    bool operator==(const WavyBoxGrid&) const = default;
};

/// The space between two round pipes along x.
struct AnnulusGrid {
    double inner_diameter = 0.0, outer_diameter = 0.0, length = 0.0; ///< [m]
    int cells_along = 16, cells_outwards = 8, cells_around = 32;
    int blocks_along = 1, blocks_outwards = 1, blocks_around = 2;
    double growth = 1.0;         ///< size of the outermost cell over that of the innermost
    std::optional<double> angle; ///< of a sector [rad]
    bool operator==(const AnnulusGrid&) const = default;
};

/// A straight piece or an arc of a bent pipe.
struct PipePieceGrid {
    std::optional<double> length;             ///< of a straight piece [m]
    std::optional<double> angle;              ///< of an arc [rad]
    std::optional<double> radius;             ///< of the axis of an arc [m]
    core::Vec3 towards = core::Vec3::UnitY(); ///< side to which an arc bends
    int cells = 16, blocks = 1;
    bool operator==(const PipePieceGrid&) const = default;
};

struct BentPipeGrid {
    double diameter = 0.0; ///< [m]
    int across = 16;
    double core_fraction = 0.55;
    std::vector<PipePieceGrid> pieces;
    bool operator==(const BentPipeGrid&) const = default;
};

/// A channel along x whose floor steps down.
struct SteppedChannelGrid {
    double shallow_length = 0.0, deep_length = 0.0, height = 0.0, step = 0.0, width = 0.0; ///< [m]
    int cells_shallow = 16, cells_deep = 48, cells_height = 16, cells_step = 16, cells_across = 16;
    std::optional<int> deep_cells_height, deep_cells_across; ///< of the deep part, where they are not those of the shallow one
    int blocks_shallow = 1, blocks_deep = 1, blocks_across = 1;
    bool operator==(const SteppedChannelGrid&) const = default;
};

/// Sides of imported blocks under one name.
struct NamedSides {
    std::string name;
    std::vector<std::string> sides; ///< "3.k_low": side k_low of block 3
    bool operator==(const NamedSides&) const = default;
};

/// Blocks from a Plot3D file.
struct ImportedGrid {
    std::string file;                 ///< absolute, or relative to the scene's folder until the scene is read
    double unit = 1.0;                ///< length that the number 1 stands for [m]
    double tolerance = 1e-6;          ///< within which points meet, over the smallest edge of their side
    std::optional<core::Vec3> period; ///< of the axes that repeat [m]; without it, the extent of the grid
    std::vector<NamedSides> boundaries;
    std::optional<std::string> other_sides; ///< name of all sides that meet no other and have no name
    bool operator==(const ImportedGrid&) const = default;
};

enum class CurvatureForm { spline, compact };
inline constexpr std::array<std::string_view, 2> curvature_words{"spline", "compact"};

/// Size of the cells at a boundary.
struct SpacingKeys {
    std::string boundary;
    double first_cell = 0.0; ///< [m]
    double growth = 1.2;
    bool operator==(const SpacingKeys&) const = default;
};

/// A place in the index space of a block that pulls grid lines together.
struct AttractionKeys {
    int block = 0;
    std::optional<double> i, j, k; ///< One: a surface, two: a line, three: a point.
    double strength = 0.1, reach = 4.0;
    bool operator==(const AttractionKeys&) const = default;
};

/// Elliptic generation of the insides of all blocks.
struct EllipticKeys {
    std::vector<SpacingKeys> spacing;
    std::vector<AttractionKeys> attract;
    std::vector<std::string> smooth;
    CurvatureForm curvature = CurvatureForm::spline;
    bool operator==(const EllipticKeys&) const = default;
};

void describe(Schema& s, SpacingKeys& p);
void describe(Schema& s, AttractionKeys& p);
void describe(Schema& s, EllipticKeys& p);
void describe(Schema& s, WavyBoxGrid& p);
void describe(Schema& s, AnnulusGrid& p);
void describe(Schema& s, PipePieceGrid& p);
void describe(Schema& s, BentPipeGrid& p);
void describe(Schema& s, SteppedChannelGrid& p);
void describe(Schema& s, NamedSides& p);
void describe(Schema& s, ImportedGrid& p);

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The section of a round pipe as five parts, a square core and four wings, without a singular axis.
#include "core/base/vec3.hpp"
#include <array>

namespace core {

struct Butterfly {
    double diameter = 0.05;      ///< [m]
    int core_cells = 8;          ///< across the core, even or odd
    int wing_cells = 4;          ///< from the core to the wall
    double core_fraction = 0.55; ///< half diagonal of the core over the radius
    double core_bulge = 0.5;     ///< 0: the core is a square, 1: its sides are arcs about the axis
    double wall_growth = 1.0;    ///< size of the cell at the core over that at the wall
};

/// The core, then the wings east, north, west and south of the plane.
inline constexpr int butterfly_parts = 5;

/// Cells of a part along its two directions: across and across for the core, outwards and along the rim for a wing.
[[nodiscard]] std::array<int, 2> butterfly_cells(const Butterfly& section, int part);

/// Vertex (j, k) of a part in the plane of the section, the axis at (0, 0) [m].
[[nodiscard]] Eigen::Vector2d butterfly_point(const Butterfly& section, int part, int j, int k);

/// @throws ConfigError if a number or proportion is impossible.
void check(const Butterfly& section);

/// Share of a length after `n` of `cells` cells whose sizes are in geometric progression.
/// @param growth  Size of the first cell over that of the last.
[[nodiscard]] double graded(int n, int cells, double growth);

} // namespace core

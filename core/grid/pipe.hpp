// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The butterfly grid of a straight round pipe along x: a square core and four wings, cut along the axis.
#include "core/grid/multi_block.hpp"

namespace core {

struct Pipe {
    double diameter = 0.05, length = 0.09; ///< [m]
    int core_cells = 8;                    ///< across the core, even or odd
    int wing_cells = 4;                    ///< from the core to the wall
    int axial_cells = 32;
    int blocks_along = 4;
    double core_fraction = 0.55; ///< half diagonal of the core over the radius
    double core_bulge = 0.5;     ///< 0: the core is a square, 1: its sides are arcs about the axis
    double wall_growth = 1.0;    ///< size of the cell at the core over that at the wall
    bool periodic = true;
};

/// Five blocks in each section (core, then wings at +y, -z... in the order east, north, west, south of the (y, z) plane)
/// times `blocks_along`. Boundary names: wall, x_low, x_high.
/// @throws ConfigError if the cells do not divide into the blocks or a proportion is impossible.
[[nodiscard]] MultiBlock make_pipe(const Pipe& pipe);

} // namespace core

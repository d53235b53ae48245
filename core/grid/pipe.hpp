// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The butterfly grid of a straight round pipe along x: a square core and four wings, cut along the axis.
#include "core/grid/butterfly.hpp"
#include "core/grid/multi_block.hpp"

namespace core {

struct Pipe : Butterfly {
    double length = 0.09; ///< [m]
    int axial_cells = 32;
    int blocks_along = 4;
    bool periodic = true;
};

/// Five blocks in each section (core, then wings at +y, -z... in the order east, north, west, south of the (y, z) plane)
/// times `blocks_along`. Boundary names: wall, x_low, x_high.
/// @throws ConfigError if the cells do not divide into the blocks or a proportion is impossible.
[[nodiscard]] MultiBlock make_pipe(const Pipe& pipe);

} // namespace core

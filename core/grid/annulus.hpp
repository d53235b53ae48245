// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The space between two round pipes along x, or a sector of it: a polar grid.
#include "core/grid/multi_block.hpp"

namespace core {

struct Annulus {
    double inner_diameter = 0.05, outer_diameter = 0.1, length = 0.1; ///< [m]
    Extents cells{8, 8, 32};                                          ///< along x, outwards, around
    Extents blocks{1, 1, 2};                                          ///< that each direction is cut into
    double growth = 1.0;                                              ///< size of the outermost cell over that of the innermost
    bool periodic = false;                                            ///< along x
    std::optional<double> angle;                                      ///< of a sector, from the y axis towards z [rad]
};

/// i runs along x, j outwards, k around. Boundary names: inner, outer, x_low, x_high; of a sector that is not joined to itself by a
/// turn, angle_low and angle_high.
/// @throws ConfigError if cells do not divide into blocks or there are fewer than three around.
[[nodiscard]] MultiBlock make_annulus(const Annulus& annulus);

} // namespace core

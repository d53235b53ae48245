// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The control functions of elliptic grid generation: what the user asks of the grid lines, as sources of the Poisson system.
#include "core/grid/line_spline.hpp"
#include "core/grid/multi_block.hpp"
#include <array>
#include <optional>

namespace core {

/// Pulls grid lines together at places of index space: a grid surface (one coordinate given), a line (two) or a point.
/// @source  Thompson, Warsi & Mastin (1985), chapter VI: exponentials of the distance in index space.
struct Attraction {
    std::array<std::optional<double>, 3> at; ///< index of a vertex along each axis
    double strength = 0.1;                   ///< natural logarithm of the growth of cells next to the place; negative: pushes away
    double reach = 4;                        ///< cells over which it falls by 1/e
};

/// Size and growth of the cells at a side.
struct WallSpacing {
    Side side = Side::j_low;
    double first_cell = 0; ///< height of the first cell along the normal of the side [m]
    double growth = 1.2;   ///< largest ratio of neighbours; near curved walls a little more where the height needs it
};

/// Sources of the Poisson system at the vertices: div grad xi_m = source_m + g^mm factor_m, indices with unit spacing.
struct ControlFunctions {
    std::array<Array3<double>, 3> source; ///< [1/m2], the form of Ushijima & Nezu (2001), eq. (1)
    std::array<Array3<double>, 3> factor; ///< [-], the form of Thompson, Warsi & Mastin (1985)
};

/// None: zero everywhere.
[[nodiscard]] ControlFunctions no_control(Extents vertices);

/// Adds to the factors.
void add_attraction(const Attraction& attraction, ControlFunctions& control);

/// The factors that keep a straight line of cells at `shares`: -x'' / x', with the derivatives the generator uses.
[[nodiscard]] std::vector<double> factors_of(const std::vector<double>& shares, Curvature kind);

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Elliptic grid generation: the inside of a block from its sides, by the inverted Poisson system of Thompson et al. (1985).
#include "core/grid/control_functions.hpp"

namespace core {

struct Elliptic {
    std::vector<Attraction> attractions;
    std::vector<WallSpacing> spacings;
    /// Further sources at the vertices of the block; empty arrays for none. A side takes no notice of them.
    ControlFunctions control;
    Curvature curvature = Curvature::cubic_spline;
    double tolerance = 1e-6; ///< largest move of a vertex in the last iteration, over the mean edge of the block
    int most_iterations = 300;
};

struct EllipticResult {
    int iterations = 0;
    double move = 0;          ///< of the last iteration, over the mean edge
    double control_share = 1; ///< of what was asked for; less than 1 if the full control folded cells
    double spacing_error = 0; ///< largest relative error of the first cells' heights
};

/// Solves, for the inner vertices x_i of a block,
///   sum_pq g^pq d2x_i/dxi_p dxi_q + sum_m P_m dx_i/dxi_m = 0    (Ushijima & Nezu 2001, eq. (1); NUMERICS A1'),
/// with first and pure second derivatives by splines along the grid lines and mixed ones by central differences. The inner
/// vertices given are the start; folded ones are allowed. If cells fold under the full control, less is tried.
/// @throws ConfigError if cells fold without any control too, or a spacing is impossible.
EllipticResult solve_elliptic(Vertices& block, const Elliptic& wanted);

/// Spaces the lines that leave walls with spacing, on the sides of the block too, and then solves.
EllipticResult make_elliptic(Vertices& block, const Elliptic& wanted);

/// The same on one side of a block that lies in a plane: its inner vertices follow from its four edges. Spacings of the sides
/// next to it and attractions along its two axes count.
/// @throws ConfigError also if the side is not plane.
EllipticResult make_elliptic_side(Vertices& block, Side side, const Elliptic& wanted);

} // namespace core

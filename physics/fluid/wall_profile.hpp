// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a velocity bends beside a boundary that gives it: a parabola through the boundary and the two cells next to it. With a straight
// line from the boundary to the cell viscosity beside it is wrong by a quarter on even grids, however fine they are.
#include "physics/fluid/diffusion.hpp"

namespace physics {

/// At one face of a boundary with at least two cells behind it, whose centres lie d and D away from it. Straight lines have slopes a
/// from the boundary to the first and b from there to the second; the parabola's slope on the boundary is a + d/D (a - b).
struct WallProfile {
    core::Index3 face, cell, inner; ///< the face, the first cell, the second
    double share;                   ///< d/D
    double own, next;               ///< shares of (q - q on the boundary) and (q inner - q) in the flux that the bend adds [m]

    WallProfile(const core::BlockGeometry& geometry, core::Side side, core::Index3 at);
    /// What the bend adds to the flux of the gradient into the cell [unit of q m].
    [[nodiscard]] double inflow(double from_boundary, double to_inner) const { return next * to_inner - own * from_boundary; }
};

/// Does a side have profiles: does it give the velocity of two cells or more behind it?
[[nodiscard]] bool has_profiles(const core::BlockGeometry& geometry, const BlockWalls& walls, core::Side side);

/// Calls body(side, profile) for every face that has one.
template <class Body>
void for_each_wall_profile(const core::BlockGeometry& geometry, const BlockWalls& walls, Body body)
{
    for (const core::Side side : core::all_sides)
        if (has_profiles(geometry, walls, side))
            for_each_side_face(geometry.cells, side, [&](int i, int j, int k) { body(side, WallProfile(geometry, side, {i, j, k})); });
}

/// What the bend adds to the net flux of grad q into the cells beside boundaries.
/// @param q  One layer beyond boundaries, mirrored about its value there.
void add_bend(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q, core::View<double> inflow);
/// The same, on the faces of the boundaries.
void add_bend(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q, core::FaceView<double> flux);

/// Gradient of a component of a velocity, or of a change of one: that of least squares, in cells beside boundaries of the parabola.
/// Exact for linear fields. Where turbulence adds viscosity it is left plain: its formulas for walls have been made for that.
/// @param q         One halo layer, mirrored as above.
/// @param[out] out  Interior [unit of q / m].
void velocity_gradient(const core::BlockGeometry& geometry, const BlockWalls& walls, const FaceFactors& factors, core::View<const double> q,
                       core::VectorView<double> out);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Semi-Lagrangian advection in index space (LCSI): where the water of a cell came from, and what it carried.
#include "core/grid/geometry.hpp"
#include "core/grid/topology.hpp"

namespace physics {

/// Velocity whose flux through a cell is the mean of those through its faces. What carries a flow must be as free of divergence as
/// the fluxes are: velocities of cells hide modes from the pressure, and a flow that they carry gains energy by itself.
/// @param flux       Through faces [m3/s].
/// @param[out] out   Interior [m/s].
void transport_velocity(const core::BlockGeometry& geometry, core::FaceView<const double> flux, core::VectorView<double> out);

/// How the velocity of the last two times goes on to the middle of the step; one halo layer each.
struct Extrapolation {
    core::VectorView<const double> velocity, before;
    double weight; ///< of (velocity - before): half of this step over the step before; 0 leaves them out
};

/// Velocity in cells per second, U_m = d(xi_m)/d(x_j) u_j, at the middle of the step.
/// @param transport            At the start of the step, one halo layer.
/// @param[out] index_velocity  Interior and one halo layer [1/s].
void index_velocity(const core::BlockGeometry& geometry, core::VectorView<const double> transport, const Extrapolation& change,
                    core::VectorView<double> index_velocity);

/// The longest way of a block along one axis, and the cell where it ends.
struct LongestWay {
    double cells = 0;
    core::Index3 cell;
};

/// Displacement in cells over one step, by two iterations of the midpoint rule with trilinear velocity; clipped to one
/// cell in each direction, which is as far as the stencils reach.
/// @param index_velocity     One halo layer [1/s].
/// @param[out] displacement  Interior [cells].
/// @return What was longest before it was clipped.
[[nodiscard]] LongestWay trajectories(core::VectorView<const double> index_velocity, double dt, core::VectorView<double> displacement);

/// @throws core::NumericsError naming block and cell if water came from farther than stencils and halos reach.
void require_within_reach(const LongestWay& way, core::BlockId block, double dt);

/// Axes along which the singular edges of a block run (edges where three or five blocks meet). Stencils may have six points
/// along them, but not across.
/// @param block  Global id.
[[nodiscard]] std::array<bool, 3> singular_axes(const core::Topology& topology, core::BlockId block);

/// Curve through six points along each axis.
enum class Interpolation {
    hermite, ///< amplifies no mode
    spline   ///< the literal local spline
};

/// q at the departure points: tensor product of six-point interpolation; where the six points would reach round a
/// singular edge, linear in the directions across it.
/// @param q             Three halo layers.
/// @param singular      Of singular_axes().
/// @param displacement  At most one cell in each direction.
/// @source  NUMERICS A5 (after Ushijima 1994): Hermite is the member of the family that amplifies no mode.
void advect(const core::BlockGeometry& geometry, core::VectorView<const double> q, core::VectorView<const double> displacement,
            std::array<bool, 3> singular, core::VectorView<double> out, Interpolation interpolation = Interpolation::hermite);

} // namespace physics

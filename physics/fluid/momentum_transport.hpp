// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finite-volume advection of momentum: one flux of it through every face, so that boundaries alone change its sum over all cells.
// What is carried is q, the velocity with the explicit half of what accelerates it, as in advection_lcsi.hpp:
//   V q' = V q - dt sum F q_face,   q_face of the middle of the step, third order upwind on uniform grids (bounded_transport.hpp).
// Linear stability allows 1.35 V to leave a cell in a step, from von Neumann's analysis in one to three dimensions.
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/bounded_transport.hpp"

namespace physics {

/// The flux in the middle of a step; the present one takes the place of the one before.
/// @param weight  Of (flux - before): half of this step over the step before.
void middle_flux(double weight, core::FaceView<const double> flux, core::FaceView<double> before, core::FaceView<double> middle);

/// q - dt/2 w . grad u in the centres of cells.
/// @param transport  w [m/s].
/// @param gradients  Of the components of u [1/s].
void middle_velocity(double dt, core::VectorView<const double> transport, core::VectorView<const double> q,
                     const std::array<core::VectorView<const double>, 3>& gradients, core::VectorView<double> middle);

/// What is carried, and from what its values on faces follow; one halo layer each.
struct CarriedVelocity {
    core::VectorView<const double> velocity, middle;
    std::array<core::VectorView<const double>, 3> gradients; ///< of velocity [1/s]
};

/// Boundaries of a block at the start and at the end of a step.
struct FlowBoundaries {
    const core::BlockGeometry& geometry;
    const BlockWalls &before, &after;
};
/// What one component carries through the boundaries of a block; no other face is touched.
/// @param inside  Velocity in the cells beside them, in the middle of the step [m/s].
void boundary_momentum_flux(const FlowBoundaries& boundaries, int component, core::FaceView<const double> flux,
                            core::VectorView<const double> inside, core::FaceView<double> out);

/// Outflow of momentum from each cell but through sub-faces (sub_face_momentum.hpp), per unit density [m4/s2].
/// @param flux          In the middle of the step [m3/s].
/// @param scratch       For the flux of one component.
/// @param[out] outflow  Interior.
struct MomentumTransport {
    const core::BlockGeometry& geometry;
    const BlockWalls &walls_before, &walls; ///< at the start and at the end of the step
    const FaceCentres& centres;
};
void momentum_outflow(const MomentumTransport& transport, core::FaceView<const double> flux, const CarriedVelocity& carried,
                      core::FaceView<double> scratch, core::VectorView<double> outflow);

/// @throws core::NumericsError naming the block if more of the fluid of a cell leaves it than the scheme bears.
void require_stable_outflow(double rate, core::BlockId block, double dt);

} // namespace physics

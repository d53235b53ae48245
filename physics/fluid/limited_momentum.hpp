// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finite-volume advection of the momentum of a fluid that fills a share phi of each cell, F its own volume flux through faces:
//   phi' V = phi V - dt sum F,   phi' V u' = phi V u - dt sum F u_face,   u_face of the middle of the step.
// A uniform flow stays uniform whatever phi and F are, and boundaries alone change the sum of phi V u. Where phi jumps u does, and
// beside a share that is small what overshoots would count much: here, other than in momentum_transport.hpp, what high order adds to the
// upwind value is limited, all components of a vector alike, so that flows turn with their scenes.
#include "physics/fluid/momentum_transport.hpp"

namespace physics {

/// Flux of each component of the velocity through faces and sub-faces [m4/s2].
using MomentumFlux = std::array<core::FaceView<double>, 3>;
using KnownMomentumFlux = std::array<core::FaceView<const double>, 3>;

/// How a velocity is carried in a step.
struct LimitedMomentum {
    MomentumTransport transport;
    core::FaceView<const double> flux;      ///< F in the middle of the step [m3/s]
    CarriedVelocity carried;                ///< middle: u + dt/2 (a - w . grad u), a all other acceleration
    core::VectorView<const double> carrier; ///< w, one halo layer [m/s]
    double dt;
};

/// The value on a face is that of the upwind cell and c ((middle - u) + g . r + bend / 6), as in bounded_transport.hpp. c is 1 where
/// what of it is transport, d, lies in the balls that have the differences D to the cell beyond and to that behind as diameters,
/// d . d <= d . D, else less; the latter ball is smaller where more than half of the fluid of a cell leaves it. Where all else that
/// accelerates does much more than transport, c is 1.
void limited_momentum_flux(const LimitedMomentum& momentum, const MomentumFlux& out);

/// Cells and what is in them.
struct SharedCells {
    const core::BlockGeometry& geometry;
    core::BlockId block;
    core::View<const double> share;          ///< phi
    core::VectorView<const double> velocity; ///< u [m/s]
    double dt;
};
/// u' and phi'.
/// @throws core::NumericsError naming the block if a cell is left without fluid.
void carry_momentum(const SharedCells& cells, core::FaceView<const double> flux, const KnownMomentumFlux& momentum,
                    core::View<double> share_after, core::VectorView<double> velocity_after);

/// Flux of the upwind velocity, for fluxes that are small beside those of the flow [m4/s2].
/// @param velocity  One halo layer.
void upwind_momentum_flux(const FlowBoundaries& boundaries, core::FaceView<const double> flux, core::VectorView<const double> velocity,
                          const MomentumFlux& out);

/// The largest share of the fluid of a cell that leaves it in a time [1/s].
[[nodiscard]] double largest_outflow_rate(const core::BlockGeometry& geometry, core::FaceView<const double> flux,
                                          core::View<const double> share, core::View<double> scratch);

} // namespace physics

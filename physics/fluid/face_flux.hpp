// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fluxes through the faces of a block: of gradients by the one compact formula, of vectors by linear interpolation.
#include "physics/fluid/boundary.hpp"
#include "physics/fluid/side_faces.hpp"

namespace physics {

/// Flux of grad q through every face, F = T (q_b - q_a) + (S - T d) . (g_a + g_b) / 2, towards increasing index.
/// Faces on walls get values that mean nothing: follow with one of the three below.
/// @param q          One halo layer.
/// @param gradients  Of q, one halo layer.
/// @param[out] flux  [unit of q m].
void gradient_flux(const core::BlockGeometry& geometry, core::View<const double> q, core::VectorView<const double> gradients,
                   core::FaceView<double> flux);

/// Nothing goes through boundaries whose flux is given.
void close_walls(const BlockWalls& walls, core::FaceView<double> flux);
/// Nothing goes through any boundary.
void close_boundaries(const BlockWalls& walls, core::FaceView<double> flux);

/// Flux of grad q through boundaries: T (q_boundary - q). The gradient along the boundary is left out: it vanishes where q is given.
/// @param q  One layer beyond boundaries, mirrored as boundary_halo.hpp does it.
void wall_gradient_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q,
                        core::FaceView<double> flux);

/// The same of a pressure, or a change of one: nothing goes through boundaries whose flux is given.
void pressure_wall_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> pressure,
                        core::FaceView<double> flux);

/// Flux of a vector through every face, linear between the cell centres; walls and inflows have their own velocity.
/// @param u  One halo layer.
void interpolated_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::VectorView<const double> u,
                       core::FaceView<double> flux);

/// What walls carry through themselves by moving, and what flows in.
void wall_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::FaceView<double> flux);

/// Net outflow of each cell.
/// @param[out] outflow  Interior [unit of flux].
void net_outflow(core::FaceView<const double> flux, core::View<double> outflow);

/// Half the sum of the magnitudes of the fluxes of each cell.
void throughput(core::FaceView<const double> flux, core::View<double> through);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Kernels of the k-epsilon model on one block whose grid resolves the layers at walls.
#include "physics/fluid/k_epsilon_resolved.hpp"
#include "physics/fluid/turbulence.hpp"

namespace physics {

/// The model of Abe, Kondoh and Nagano on a block.
struct ResolvedWalls {
    double viscosity; ///< [m2/s]
    const std::vector<WallCell>& cells;
    core::View<const double> distance; ///< of cells from the nearest wall [m]
};

/// As of the standard model (turbulence.hpp), damped towards walls.
void find_eddy_viscosity(const ResolvedWalls& walls, core::View<const double> k, core::View<const double> epsilon,
                         core::View<const double> strain, core::View<double> out);
/// On walls the viscosity is that of the fluid.
/// @param k  Has no part in it.
void set_wall_viscosity(const ResolvedWalls& walls, core::View<const double> k, core::FaceView<double> ratio);
/// What is lost is lost implicitly: k and epsilon stay positive for any dt, and where all balances the balance does not depend on dt.
/// Beside walls epsilon is 2 nu k / y^2, so that k grows with the square of the distance, exactly, and none of it passes the wall.
void form_sources(const BlockWalls& sides, const ResolvedWalls& walls, core::VectorView<const double> velocity, double dt,
                  TurbulenceCells cells, TurbulenceEquations out);

} // namespace physics

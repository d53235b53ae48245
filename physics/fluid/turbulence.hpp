// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Kernels of the k-epsilon model on one block.
#include "physics/fluid/k_epsilon.hpp"
#include "physics/fluid/wall_cells.hpp"

namespace physics {

/// Eddy viscosity of each cell [m2/s].
void eddy_viscosity(double viscosity, core::View<const double> k, core::View<const double> epsilon, core::View<double> out);

/// Viscosity on faces over that of the fluid: between cells by linear interpolation, on walls that of their layer, on other
/// boundaries that of the cell inside.
/// @param eddy  One halo layer [m2/s].
/// @param k     Interior.
struct WallsOfTurbulence {
    double viscosity, roughness; ///< [m2/s], [m]
    const std::vector<WallCell>& cells;
};
void viscosity_on_faces(const core::BlockGeometry& geometry, const BlockWalls& sides, const WallsOfTurbulence& walls,
                        core::View<const double> eddy, core::View<const double> k, core::FaceView<double> ratio);

/// 2 S_ij S_ij of the part of the strain that keeps volume, from the gradients of the components of velocity [1/s2].
void strain(core::VectorView<const double> gradient_x, core::VectorView<const double> gradient_y, core::VectorView<const double> gradient_z,
            core::View<double> out);

/// w + dt s and the right-hand side of the implicit step of a quantity (see scalar_diffusion.hpp), for w = 1.
struct SourceTerms {
    double capacity, source;
};
struct TurbulenceSources {
    SourceTerms k, epsilon;
};
/// Decay goes as it would without production and diffusion, exactly: these act at the mean pace of the decay. So k and epsilon stay
/// positive for any dt, decaying turbulence is exact, and where all balances the balance does not depend on dt.
/// @param produced  Production of k [m2/s3].
[[nodiscard]] TurbulenceSources turbulence_sources(const Turbulence& at, double produced, double dt);

/// The sources of all cells; what lies beside walls has production and dissipation of their layer.
struct TurbulenceCells {
    core::View<double> k, epsilon;  ///< updated: epsilon beside walls becomes that of their layer
    core::View<double> produced;    ///< 2 S_ij S_ij in, production out
    core::View<const double> share; ///< w
};
struct TurbulenceEquations {
    core::View<double> k_capacity, k_source, epsilon_capacity, epsilon_source;
    core::View<double> free; ///< 0 where epsilon is that of a wall's layer, else 1
};
void form_sources(const BlockWalls& sides, const WallsOfTurbulence& walls, core::VectorView<const double> velocity, double dt,
                  TurbulenceCells cells, TurbulenceEquations out);

} // namespace physics

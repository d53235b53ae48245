// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Kernels of the k-epsilon model on one block, with functions for the layers at walls.
#include "physics/fluid/k_epsilon.hpp"
#include "physics/fluid/wall_cells.hpp"

namespace physics {

/// 2 S_ij S_ij of the part of the strain that keeps volume, from the gradients of the components of velocity [1/s2].
void strain(core::VectorView<const double> gradient_x, core::VectorView<const double> gradient_y, core::VectorView<const double> gradient_z,
            core::View<double> out);

/// Viscosity on faces over that of the fluid: between cells by linear interpolation, on boundaries that of the cell inside.
/// @param eddy  One halo layer [m2/s].
void viscosity_on_faces(const core::BlockGeometry& geometry, const BlockWalls& sides, double viscosity, core::View<const double> eddy,
                        core::FaceView<double> ratio);

/// w + dt s and the right-hand side of the implicit step of a quantity (see scalar_diffusion.hpp), for w = 1.
struct SourceTerms {
    double capacity, source;
};
struct TurbulenceSources {
    SourceTerms k, epsilon;
};

/// What turbulence is in the cells of a block.
struct TurbulenceCells {
    core::View<double> k, epsilon;    ///< updated: epsilon beside walls becomes that of their layer
    core::View<const double> forcing; ///< what diffusion does to epsilon / k [1/s2]
    core::View<double> strain;        ///< 2 S_ij S_ij; updated: 0 where it is the wall's layer that strains [1/s2]
    core::View<const double> share;   ///< w
};
struct TurbulenceEquations {
    core::View<double> k_capacity, k_source, epsilon_capacity, epsilon_source;
    core::View<double> free; ///< 0 where epsilon is that of a wall's layer, else 1
};

/// The standard model on a block whose walls are seen through functions.
struct ModelledWalls {
    double viscosity, roughness; ///< [m2/s], [m]
    const std::vector<WallCell>& cells;
};

/// Eddy viscosity of each cell [m2/s].
void find_eddy_viscosity(const ModelledWalls& walls, core::View<const double> k, core::View<const double> epsilon,
                         core::View<const double> strain, core::View<double> out);
/// On walls the ratio becomes that of their layer.
/// @param k  Interior.
void set_wall_viscosity(const ModelledWalls& walls, core::View<const double> k, core::FaceView<double> ratio);
/// The sources of all cells; what lies beside walls has production and dissipation of their layer.
void form_sources(const BlockWalls& sides, const ModelledWalls& walls, core::VectorView<const double> velocity, double dt,
                  TurbulenceCells cells, TurbulenceEquations out);

/// The rate epsilon / k goes as it would with production and forcing that do not change, exactly, and with it the growth of k and
/// epsilon. So these stay positive for any dt, turbulence that decays or grows in uniform strain is exact, all is second order in
/// time, and where all balances the balance does not depend on dt. What diffuses acts at the mean pace of the growth.
/// @param produced  Production of k [m2/s3].
/// @param forcing   What diffusion does to epsilon / k per time [1/s2].
[[nodiscard]] TurbulenceSources turbulence_sources(const Turbulence& at, double produced, double forcing, double dt);

/// The forcing of the step that was just solved, for the next one; 0 beside walls and where there is no turbulence.
void find_forcing(TurbulenceEquations equations, TurbulenceCells cells, double dt, core::View<double> forcing);

} // namespace physics

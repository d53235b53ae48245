// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The volume flux of the fluid itself over a step, the mean of old and new: that through the faces, less what grains carry.
#include "physics/steps/coupled_step.hpp"

namespace physics {

class FluidFlux {
public:
    /// @param carried    What the flux is for, in the names of stages.
    /// @param coupling   None where the fluid is alone; all references must outlive the flux.
    FluidFlux(const core::Mesh& mesh, FluidStep& fluid, CoupledStep* coupling, const std::string& carried);

    /// Before the stages of the fluid.
    void declare_old_half(tasks::StageGraph& graph);
    /// After them.
    enum class Grains {
        as_before, ///< at the start of the step: what the fluid does need not wait for the grains
        moved
    };
    void declare_new_half(tasks::StageGraph& graph, Grains grains);

    /// Shares of the cells that the fluid fills: 1 where it is alone.
    void declare_shares(tasks::StageGraph& graph, core::ScalarField& out);
    [[nodiscard]] core::FaceField& mean() { return mean_; }
    /// The grains' part of the exchange; none where the fluid is alone.
    [[nodiscard]] CoupledStep* coupling() const { return coupling_; }

private:
    void declare_solid(tasks::StageGraph& graph);
    void find_flux_of_grains(core::LocalBlock b, core::VectorView<const double> density, core::FaceView<double> flux) const;

    const core::Mesh& mesh_;
    FluidStep& fluid_;
    CoupledStep* coupling_;
    std::string carried_;
    core::FaceField mean_, scratch_;
    core::VectorField solid_; ///< flux density of the grains [m/s]
};

/// Mean of the two cells of each face.
/// @param q  One halo layer.
void mean_on_faces(const core::BlockGeometry& geometry, core::View<const double> q, core::FaceView<double> faces);

} // namespace physics

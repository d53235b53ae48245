// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Turbulence by the k-epsilon model beside the step of the fluid: its viscosity before, k and epsilon after.
#include "physics/fluid/turbulence_resolved.hpp"
#include "physics/steps/fluid_flux.hpp"
#include "physics/steps/scalar_carrier.hpp"
#include "physics/steps/scalar_diffusion.hpp"
#include <variant>

namespace physics {

class TurbulenceStep {
public:
    /// Makes the fluid use the viscosity of turbulence; all references must outlive the step. Collective.
    /// @param coupling  With grains, whose place turbulence does not take; none where the fluid is alone.
    /// @throws ConfigError for a name that no boundary has, or a fluid without viscosity.
    TurbulenceStep(const core::Mesh& mesh, FluidStep& fluid, const TurbulenceParameters& parameters, CoupledStep* coupling = nullptr);
    TurbulenceStep(const TurbulenceStep&) = delete;
    TurbulenceStep& operator=(const TurbulenceStep&) = delete;

    /// For grains that feel the fluid, which does not feel them: as beside others, each step finds the viscosity of the next, for it acts
    /// on them too. Before anything is declared.
    void act_on_grains();
    /// What is needed of the old fluxes, and where the fluid is alone its viscosity: to be declared before the stages of the fluid.
    void declare_before(tasks::StageGraph& graph);
    /// To be declared where the new velocity is known. With grains the viscosity of the next step follows, for it acts on them too.
    void declare(tasks::StageGraph& graph);
    /// Viscosity at once: to be called whenever the state was set from outside, if there are grains. Collective.
    [[nodiscard]] tasks::Job find_viscosity(tasks::Lane& lane);

    [[nodiscard]] core::ScalarField& k() { return k_; }
    [[nodiscard]] const core::ScalarField& k() const { return k_; }
    [[nodiscard]] core::ScalarField& epsilon() { return epsilon_; }
    [[nodiscard]] const core::ScalarField& epsilon() const { return epsilon_; }
    /// 2 S_ij S_ij at the start of the last step, which bounds the viscosity of the next; 0 beside walls that are not resolved [1/s2].
    [[nodiscard]] core::ScalarField& strain() { return strain_; }
    /// What diffusion did to epsilon / k in the last step; 0 where walls are resolved [1/s2].
    [[nodiscard]] core::ScalarField& forcing() { return forcing_; }
    [[nodiscard]] core::Array3<double> eddy_viscosity(core::LocalBlock b) const;

private:
    void declare_viscosity(tasks::StageGraph& graph);
    void declare_damping(tasks::StageGraph& graph, core::FieldBatch<resisting>& grains);
    tasks::Job advance(tasks::Lane& lane, const core::FaceField& flux, double dt, const core::VectorField& velocity);
    void set_viscosity_on_faces(core::LocalBlock b, core::View<const double> eddy, core::View<const double> k,
                                core::FaceView<double> ratio) const;
    tasks::Job find_face_shares(tasks::Lane& lane);
    tasks::Job solve(tasks::Lane& lane, double dt);
    [[nodiscard]] TurbulenceCells cells(core::LocalBlock b);
    [[nodiscard]] TurbulenceEquations equations(core::LocalBlock b);
    void set_diffusivity(tasks::Lane& lane, double sigma);
    [[nodiscard]] std::variant<ModelledWalls, ResolvedWalls> walls(core::LocalBlock b) const;
    [[nodiscard]] const BlockWalls& sides(core::LocalBlock b) const { return fluid_.walls()[std::size_t(b)]; }
    template <class Body>
    void for_blocks(tasks::Lane& lane, Body body) const
    {
        lane.team().run(mesh_.own_count(), [&](int b) { body(core::LocalBlock(b)); });
    }

    const core::Mesh& mesh_;
    FluidStep& fluid_;
    TurbulenceParameters parameters_;
    bool acts_on_grains_;
    std::vector<std::vector<WallCell>> wall_cells_;   ///< of each block of this rank
    std::vector<core::Array3<double>> wall_distance_; ///< only where walls are resolved
    std::vector<EntryValues> entering_k_, entering_epsilon_;
    core::ScalarField k_, epsilon_, strain_, forcing_;
    core::ScalarField eddy_, share_;
    core::ScalarField k_capacity_, k_source_, epsilon_capacity_, epsilon_source_, free_;
    FluidFlux flux_;
    core::FaceField face_share_, diffusivity_;
    tasks::Part<FluidClock> clock_;
    tasks::HaloFiller& halos_;
    ScalarCarrier carrier_;
    ScalarDiffusion diffusion_;
};

} // namespace physics

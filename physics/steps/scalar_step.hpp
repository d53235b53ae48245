// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Passive scalars in the fluid: carried with its fluxes, then diffused. Beside grains the fluxes are made to agree with the share of
// each cell that the fluid fills, before and after: so what is carried stays in its range, and its amount too.
#include "physics/steps/fluid_flux.hpp"
#include "physics/steps/scalar_carrier.hpp"
#include "physics/steps/scalar_diffusion.hpp"

namespace physics {

class ScalarStep {
public:
    /// The fluid must outlive the step. Collective.
    /// @throws ConfigError for a name that no boundary has.
    /// @param ranks, coupling  Of the grains; none where the fluid is alone.
    ScalarStep(const core::Mesh& mesh, FluidStep& fluid, const std::vector<ScalarParameters>& scalars, CoupledStep* coupling = nullptr,
               const core::Communicator& ranks = core::Communicator::self());
    ~ScalarStep();
    ScalarStep(const ScalarStep&) = delete;
    ScalarStep& operator=(const ScalarStep&) = delete;

    /// What is needed of the old fluxes: to be declared before the stages of the fluid.
    void declare_before(tasks::StageGraph& graph);
    /// To be declared after all other stages.
    void declare(tasks::StageGraph& graph);
    /// Where the fluid shares its cells with grains, as they are: to be called before the first step of a new state.
    void begin(const core::ScalarField& fraction);

    [[nodiscard]] ScalarSet& fields() { return fields_; }
    [[nodiscard]] const ScalarSet& fields() const { return fields_; }
    [[nodiscard]] const std::vector<ScalarParameters>& parameters() const { return parameters_; }
    /// Parts that the last step was carried in.
    [[nodiscard]] int parts() const { return carrier_.parts(); }

private:
    tasks::Job carry(tasks::Lane& lane, core::FaceField& flux, double dt, ScalarSet& fields);
    tasks::Job diffuse(tasks::Lane& lane, double dt, ScalarSet& fields);
    /// Makes the flux such that carrying it fills the shares of the cells that the grains leave.
    tasks::Job agree_with_grains(tasks::Lane& lane, core::FaceField& flux, double dt, ScalarSet& fields);

    const core::Mesh& mesh_;
    FluidStep& fluid_;
    std::vector<ScalarParameters> parameters_;
    std::vector<std::vector<EntryValues>> entering_; ///< of each scalar
    ScalarSet fields_;
    tasks::Part<ScalarSet> part_;
    tasks::Part<FluidClock> clock_;
    ScalarCarrier carrier_;
    std::unique_ptr<ScalarDiffusion> diffusion_; ///< none if nothing diffuses
    FluidFlux flux_;
    core::FaceField diffusivity_;
    core::ScalarField source_;
    struct Agreement;
    std::unique_ptr<Agreement> agreement_; ///< with grains
};

} // namespace physics

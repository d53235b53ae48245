// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Passive scalars in the fluid: carried with its fluxes, then diffused.
#include "physics/steps/fluid_step.hpp"
#include "physics/steps/scalar_carrier.hpp"
#include "physics/steps/scalar_diffusion.hpp"

namespace physics {

class ScalarStep {
public:
    /// The fluid must outlive the step. Collective.
    /// @throws ConfigError for a name that no boundary has.
    ScalarStep(const core::Mesh& mesh, FluidStep& fluid, const std::vector<ScalarParameters>& scalars);
    ScalarStep(const ScalarStep&) = delete;
    ScalarStep& operator=(const ScalarStep&) = delete;

    /// What is needed of the old fluxes: to be declared before the stages of the fluid.
    void declare_before(tasks::StageGraph& graph);
    /// To be declared after the stages of the fluid.
    void declare(tasks::StageGraph& graph);

    [[nodiscard]] ScalarSet& fields() { return fields_; }
    [[nodiscard]] const ScalarSet& fields() const { return fields_; }
    [[nodiscard]] const std::vector<ScalarParameters>& parameters() const { return parameters_; }
    /// Parts that the last step was carried in.
    [[nodiscard]] int parts() const { return carrier_.parts(); }

private:
    tasks::Job diffuse(tasks::Lane& lane, double dt, ScalarSet& fields);

    const core::Mesh& mesh_;
    FluidStep& fluid_;
    std::vector<ScalarParameters> parameters_;
    std::vector<std::vector<EntryValues>> entering_; ///< of each scalar
    ScalarSet fields_;
    tasks::Part<ScalarSet> part_;
    tasks::Part<FluidClock> clock_;
    ScalarCarrier carrier_;
    std::unique_ptr<ScalarDiffusion> diffusion_; ///< none if nothing diffuses
    core::FaceField flux_;                       ///< that carries, mean over the step [m3/s]
    core::FaceField diffusivity_;
    core::ScalarField source_;
};

} // namespace physics

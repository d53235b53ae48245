// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A fluid that grains feel and that does not feel them: its own step without any grain, beside it the sub-steps of the grains in the fluid
// of the old time. Nothing is deposited, the fluid fraction is 1 everywhere, for drag laws too, and neither lane waits for the other.
// What the fluid does within the step reaches the grains as what they are owed, as in steps 2 and 6 of response.hpp: second order in time.
#include "physics/particles/stepper.hpp"
#include "physics/steps/fluid_views.hpp"
#include "physics/steps/step_company.hpp"

namespace physics {

class OneWayStep {
public:
    /// All references must outlive the step. Collective.
    /// @pre Neither mixtures nor own disturbances among the parameters: they are of grains that the fluid feels.
    OneWayStep(const core::Locator& locator, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid,
               ParticleDynamics& grains, ParticleStepper& stepper, const CouplingParameters& parameters);
    OneWayStep(const OneWayStep&) = delete;
    OneWayStep& operator=(const OneWayStep&) = delete;

    void declare(tasks::StageGraph& graph, const StepCompany& company);
    /// Finds the grains among the cells and what they are told: to be called whenever the state was set from outside. Collective.
    [[nodiscard]] tasks::Job initialise(tasks::Lane& lane);

    [[nodiscard]] const GrainExchange& exchange() const { return exchange_; }
    /// What grains see of the fluid.
    [[nodiscard]] FluidViews& views() { return views_; }
    [[nodiscard]] int filter_degree() const { return filter_.own.degree(); }
    /// Du/Dt of the last step without viscosity's part, carried from step to step.
    [[nodiscard]] core::VectorField& acceleration() { return fields_.acceleration; }
    /// Sub-steps of the grains in the step that is being made.
    int sub_steps = 1;

private:
    void declare_grains(tasks::StageGraph& graph);
    void declare_answer(tasks::StageGraph& graph);
    /// Places and holds after the sub-steps. @throws NumericsError
    void find_grains(const ParticleDynamics& grains, GrainPlaces& places, GrainHolds& holds) const;
    [[nodiscard]] core::Vec3 correction_of(const DriveState& drive) const;

    const core::Mesh& mesh_;
    const core::Communicator& ranks_;
    const core::Locator& locator_;
    FluidStep& fluid_;
    ParticleStepper& stepper_;
    ExchangeFields fields_; ///< of which the sums over grains, and what follows from them, have no memory
    FluidViews views_;
    GrainExchange exchange_;
    LaneFilter filter_;
    ParticleDynamics& dynamics_;
    tasks::Part<ParticleDynamics> grains_;
    tasks::Part<FluidClock> clock_;
    tasks::Value<GrainPlaces> places_;
    tasks::Value<GrainHolds> holds_;
};

} // namespace physics

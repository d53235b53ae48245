// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The step of the fluid as stages: advection, implicit viscosity, projection. One step, second order, here with departure points
// (momentum_transport.hpp has u_a by finite volumes):
//   u_a = (u + (1 - s) dt nu Lap u - dt/2 grad p / rho) at the departure point,
//   u*  = u_a + dt drive - dt/2 grad p / rho + s dt nu Lap u*,      s = 1/2, or 1 after a jump of the forcing
//   u   = u* - (dt / rho) grad dp,  p = p + dp,                     p in the middle of the step
#include "physics/fluid/momentum_budget.hpp"
#include "physics/fluid/momentum_transport.hpp"
#include "physics/fluid/state.hpp"
#include "physics/steps/flow_control.hpp"
#include "physics/steps/fluid_fields.hpp"
#include "physics/steps/pressure_system.hpp"
#include "physics/steps/viscosity_system.hpp"
#include <memory>

namespace physics {

class FluidStep {
public:
    /// @param halos  Fills halos of `graph` too; all references must outlive the step. Collective.
    FluidStep(const core::Mesh& mesh, const core::Communicator& ranks, tasks::HaloFiller& halos, const FluidParameters& parameters);
    FluidStep(const FluidStep&) = delete;
    FluidStep& operator=(const FluidStep&) = delete;

    /// Sets what holds on boundaries that change in time for the step that the clock describes: to be called before it is run.
    void begin_step();
    /// From here on velocities are those of the end of the step, and the walls beside them too.
    void declare_end_of_step(tasks::StageGraph& graph);
    /// Declares all stages. Allocates the state; `budget()` is computed when the label "budget" is due.
    void declare(tasks::StageGraph& graph);
    /// What holds at walls: before any stage that reads a halo.
    void declare_boundaries(tasks::StageGraph& graph);
    /// Gradient of the pressure of the old state.
    void declare_pressure_gradient(tasks::StageGraph& graph);
    /// What a prescribed flow is expected to need.
    void declare_expected_drive(tasks::StageGraph& graph);
    /// Gradients of the components of the present velocity.
    void declare_velocity_gradients(tasks::StageGraph& graph);
    /// Viscous acceleration of the present velocity, from its gradients.
    /// @pre There is viscosity.
    void declare_viscous_acceleration(tasks::StageGraph& graph, core::VectorField& acceleration);
    /// The same at once, without stages: to be called one after the other whenever the state was set from outside, if a step
    /// starts from what they find. Collective.
    [[nodiscard]] tasks::Job find_velocity_gradients(tasks::Lane& lane);
    [[nodiscard]] tasks::Job find_viscous_acceleration(tasks::Lane& lane, core::VectorField& acceleration);
    /// What carries the fluid, where it is alone.
    void declare_transport(tasks::StageGraph& graph);
    /// Up to the predicted velocity, where the fluid is alone.
    void declare_predictor(tasks::StageGraph& graph);
    /// What flows bring: fields().advected.
    void declare_advection(tasks::StageGraph& graph);
    /// What is carried: fields().source.
    void declare_source(tasks::StageGraph& graph);
    /// What viscosity may change: what it did at the start of the step.
    void declare_viscous_guess(tasks::StageGraph& graph);
    /// Viscosity acts on the predicted velocity; what it changes begins as what it was.
    void declare_implicit_viscosity(tasks::StageGraph& graph);
    /// From the predicted velocity to the new state.
    void declare_projection(tasks::StageGraph& graph);

    // Parts of a projection, with grains or without.
    /// What faces remember of the last flux.
    /// @param carried  What cells carried then: velocity, or the flux density of the mixture [m/s].
    void declare_flux_memory(tasks::StageGraph& graph, core::VectorField& carried);
    /// The predicted flux, without pressure, from what cells carry.
    void declare_interpolated_flux(tasks::StageGraph& graph, core::VectorField& carried);
    void declare_net_outflow(tasks::StageGraph& graph);
    void declare_impulse_gradient(tasks::StageGraph& graph);
    void declare_old_velocity(tasks::StageGraph& graph);

    [[nodiscard]] const FluidParameters& parameters() const { return parameters_; }
    [[nodiscard]] bool by_finite_volumes() const { return parameters_.advection == AdvectionScheme::finite_volume; }
    [[nodiscard]] FluidState& state() { return state_; }
    [[nodiscard]] const FluidState& state() const { return state_; }
    [[nodiscard]] FluidFields& fields() { return fields_; }
    [[nodiscard]] const FluidFields& fields() const { return fields_; }
    /// What holds on boundaries at the end of the step.
    [[nodiscard]] const std::vector<BlockWalls>& walls() const { return walls_; }
    /// The same at its start.
    [[nodiscard]] const std::vector<BlockWalls>& walls_before() const { return full_walls_.empty() ? walls_ : walls_before_; }
    [[nodiscard]] PressureSystem& pressure_system() { return pressure_system_; }
    [[nodiscard]] const PressureSystem& pressure_system() const { return pressure_system_; }
    [[nodiscard]] const ViscositySystem* viscosity_system() const { return viscosity_system_.get(); }
    [[nodiscard]] const tasks::PerBlock<MomentumBudget>& budget() const { return budget_; }
    /// What the drive remembers, as a resource of stages.
    [[nodiscard]] tasks::Part<DriveState>& drive() { return drive_; }
    /// None unless the flow is prescribed.
    [[nodiscard]] FlowControl* flow_control() { return flow_control_.get(); }
    [[nodiscard]] const FlowControl* flow_control() const { return flow_control_.get(); }
    /// Do the faces of all blocks of the domain lie at right angles to the lines between cells, whole on each other?
    [[nodiscard]] bool is_straight() const { return is_straight_; }
    /// @pre by_finite_volumes()
    [[nodiscard]] MomentumTransport momentum_transport(core::LocalBlock b) const
    {
        return {geometry(b), old_walls_of(b), walls_of(b), face_centres_[std::size_t(b)]};
    }
    [[nodiscard]] FlowBoundaries flow_boundaries(core::LocalBlock b) const { return {geometry(b), old_walls_of(b), walls_of(b)}; }
    /// What other systems of equations on the same mesh refer to.
    [[nodiscard]] SystemContext system_context() const;

private:
    using Vectors = core::VectorView<const double>;
    using Gradients = core::TensorView<const double>;
    enum class Moment { start, end };
    void prepare_advection();
    void declare_departure(tasks::StageGraph& graph);
    void declare_finite_volumes(tasks::StageGraph& graph);
    void declare_sub_face_momentum(tasks::StageGraph& graph);
    /// @throws ConfigError if more flows in than out, or the other way.
    void require_balance(const core::Communicator& ranks) const;
    /// Do viscous fluxes need the gradients in cells?
    [[nodiscard]] bool viscosity_needs_gradients() const { return !is_straight_ || fields_.viscosity_ratio.used(); }
    void velocity_gradients(core::LocalBlock b, Vectors u, const core::TensorView<double>& out) const;
    void viscous_acceleration(core::LocalBlock b, Vectors u, const Gradients& gradients, core::FaceView<double> scratch,
                              core::VectorView<double> out) const;
    void declare_known_pressure(tasks::StageGraph& graph);
    void declare_correction(tasks::StageGraph& graph);
    void declare_budget(tasks::StageGraph& graph);
    [[nodiscard]] const core::BlockGeometry& geometry(core::LocalBlock b) const { return mesh_.geometry(b); }
    [[nodiscard]] const BlockWalls& walls_of(core::LocalBlock b) const { return walls_[std::size_t(b)]; }
    [[nodiscard]] const BlockWalls& walls_at(Moment moment, core::LocalBlock b) const
    {
        return moment == Moment::start ? old_walls_of(b) : walls_of(b);
    }
    [[nodiscard]] const BlockWalls& old_walls_of(core::LocalBlock b) const { return walls_before()[std::size_t(b)]; }

    const core::Mesh& mesh_;
    tasks::HaloFiller& halos_;
    FluidParameters parameters_;
    std::vector<BlockWalls> walls_;
    std::vector<BlockWalls> walls_before_, full_walls_;   ///< empty unless some change in time
    tasks::Value<Moment> moment_{"time of the velocity"}; ///< that the state has in the step
    std::vector<std::array<bool, 3>> singular_axes_;      ///< of each block of this rank, for departure points
    std::vector<FaceCentres> face_centres_;               ///< the same for finite volumes
    FluidState state_;
    FluidFields fields_;
    tasks::Part<FluidClock> clock_;
    tasks::Part<DriveState> drive_;
    bool is_straight_; ///< all blocks of the domain
    PressureSystem pressure_system_;
    std::unique_ptr<ViscositySystem> viscosity_system_; ///< none without viscosity
    std::unique_ptr<FlowControl> flow_control_;
    tasks::PerBlock<MomentumBudget> budget_;
};

} // namespace physics

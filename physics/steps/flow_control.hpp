// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finds the mean pressure gradient of a step that makes the flow through the domain what a FlowDrive prescribes.
//
// A step is linear in it. With the pressure solved for an expected gradient, Q is what flows, and E the flux on faces that one more
// unit of the gradient would make without pressure: that of the fluid as viscosity and walls hold it back in the step, or of fluid and
// grains as they answer a gradient. A first guess of what is missing, c = (Q_prescribed - Q) / Q(E), is projected as well, c E -> F_c;
// the answer is c (Q_prescribed - Q) / Q(F_c), and the flow is exact however roughly F_c was solved for. In straight ducts E is free of
// divergence and nothing is solved.
#include "physics/fluid/section_flow.hpp"
#include "physics/fluid/state.hpp"
#include "physics/steps/pressure_system.hpp"
#include "physics/steps/viscosity_system.hpp"
#include <memory>

namespace physics {

class FlowControl {
public:
    /// @param viscosity  Kinematic; 0 for an inviscid fluid [m2/s].
    FlowControl(const SystemContext& context, const FlowDrive& drive, PressureSystem& pressure, const FluidTolerances& tolerances,
                double viscosity);
    FlowControl(const FlowControl&) = delete;
    FlowControl& operator=(const FlowControl&) = delete;

    /// The gradient that the step begins with: what held the flow in the last step, and what will change it.
    /// @param flux  Of the old state.
    void declare_expected(tasks::StageGraph& graph, core::FaceField& flux, tasks::Part<FluidClock>& clock, tasks::Part<DriveState>& drive);
    /// A pass that is repeated begins with what the last one has found.
    void declare_next_pass(tasks::StageGraph& graph, tasks::Part<DriveState>& drive);
    /// Where the fluid is alone: what one more m/s2 would do to its velocity in the step.
    void declare_response(tasks::StageGraph& graph, ViscosityRatio& ratio, tasks::Part<FluidClock>& clock);
    /// Beside grains: the flux that one more Pa/m makes.
    void declare_response(tasks::StageGraph& graph, core::FaceField& mobility);

    struct Projection {
        core::ScalarField& throughput; ///< of the predicted flux
        core::ScalarField& psi;        ///< what the pressure equation gave
        core::FaceField& flux;         ///< predicted
        tasks::Part<FluidClock>& clock;
        tasks::Part<DriveState>& drive;
        double acceleration_per_unit; ///< of the response: 1, or 1 / density where it is that to a gradient
    };
    /// Corrects all of it; to be declared after the pressure is solved.
    void declare_correction(tasks::StageGraph& graph, Projection projection);
    /// Velocity gained by the correction where the fluid is alone.
    void declare_gain(tasks::StageGraph& graph, core::VectorField& predicted, tasks::Part<DriveState>& drive);
    /// Flow prescribed at a time over the mean area of sections [m/s].
    [[nodiscard]] double bulk_velocity(double time) const { return target(time) / section_.mean_area(); }

private:
    tasks::Job find_response(tasks::Lane& lane, const FluidClock& clock, const ViscosityRatio& ratio, core::VectorField& response);
    /// What the correction of a step reads and changes.
    struct Parts {
        const core::FaceField& response;
        const core::ScalarField& throughput;
        const FluidClock& clock;
        core::FaceField& trial;
        core::ScalarField& psi;
        core::FaceField& flux;
    };
    /// @param[out] units  Of the response, that are missing.
    tasks::Job correct(tasks::Lane& lane, Parts p, double& units);
    [[nodiscard]] double target(double time) const { return drive_.target(time, section_.mean_area()); }
    /// Flows of two fluxes through the section, summed over all ranks: found[0] and found[1].
    tasks::Job measure(tasks::Lane& lane, const core::FaceField& first, const core::FaceField& second, std::array<double, 2>& found);
    template <class Body>
    void for_blocks(tasks::Lane& lane, Body body) const
    {
        lane.team().run(context_.mesh.own_count(), [&](int b) { body(core::LocalBlock(b)); });
    }

    SystemContext context_;
    std::vector<BlockWalls> walls_at_rest_;
    FlowDrive drive_;
    PressureSystem& pressure_;
    SectionFlow section_;
    double viscosity_;
    std::unique_ptr<ViscositySystem> viscosity_system_; ///< none without viscosity
    core::VectorField response_, response_change_;
    core::FaceField response_flux_, trial_flux_;
    core::ScalarField outflow_, change_;
    std::vector<double> sums_;
    /// Of the response that is known: it is the same for steps of the same length, unless the viscosity changes.
    struct Known {
        double dt = 0, implicit_share = 0;
        bool operator==(const Known&) const = default;
    } known_;
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The second half of FluidStep: from the predicted velocity to the new state.
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/flux_memory.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/projection.hpp"
#include "physics/steps/fluid_step.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView, core::View;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;

void FluidStep::declare_projection(tasks::StageGraph& graph)
{
    declare_flux_memory(graph, state_.velocity);
    declare_interpolated_flux(graph, fields_.predicted);
    declare_known_pressure(graph);
    declare_net_outflow(graph);
    graph.whole(
        "solve pressure",
        [this](tasks::Lane& lane, const core::ScalarField& outflow, const core::ScalarField& throughput, const FluidClock& clock,
               core::ScalarField& psi) {
            return pressure_system_.solve(lane, {outflow, throughput, 1.0 - clock.memory()}, psi);
        },
        reads(fields_.outflow, fields_.throughput, clock_), writes(fields_.psi));
    if (flow_control_) {
        flow_control_->declare_correction(graph, {fields_.throughput, fields_.psi, fields_.predicted_flux, clock_, drive_, 1.0});
        flow_control_->declare_gain(graph, fields_.predicted, drive_);
    }
    declare_correction(graph);
}

void FluidStep::declare_flux_memory(tasks::StageGraph& graph, core::VectorField& carried)
{
    auto& f = fields_;
    graph.each_block(
        "what faces remember",
        [this](LocalBlock b, FaceView<const double> flux, Vectors u, const FluidClock& clock, FaceView<double> remembered,
               View<double> outflow) {
            if (clock.memory() > 0) split_flux(geometry(b), old_walls_of(b), flux, u, remembered, outflow);
        },
        reads(state_.flux, beside(carried), clock_), writes(f.remembered_flux, f.remembered_outflow));
}

void FluidStep::declare_interpolated_flux(tasks::StageGraph& graph, core::VectorField& carried)
{
    graph.each_block(
        "face flux", [this](LocalBlock b, Vectors u, FaceView<double> flux) { interpolated_flux(geometry(b), walls_of(b), u, flux); },
        reads(beside(carried)), writes(fields_.predicted_flux));
}

void FluidStep::declare_known_pressure(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "pressure on faces",
        [this](LocalBlock b, View<const double> p, Vectors gp, FaceView<const double> remembered, const FluidClock& clock,
               FaceView<double> scratch, FaceView<double> flux) {
            const double diffusion = clock.implicit_share() * clock.dt * parameters_.viscosity;
            add_pressure_smoothing(geometry(b), walls_of(b), clock.dt / parameters_.density, diffusion, p, gp, scratch, flux);
            wall_flux(geometry(b), walls_of(b), flux);
            add_remembered(clock.memory(), remembered, flux);
        },
        reads(beside(state_.pressure), beside(f.pressure_gradient), f.remembered_flux, clock_), writes(f.face_scratch),
        updates(f.predicted_flux));
}

void FluidStep::declare_net_outflow(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "net outflow",
        [](LocalBlock, FaceView<const double> flux, View<const double> remembered, const FluidClock& clock, View<double> outflow,
           View<double> through) {
            net_outflow(flux, outflow);
            throughput(flux, through);
            take_off_remembered(clock.memory(), remembered, outflow);
        },
        reads(f.predicted_flux, f.remembered_outflow, clock_), writes(f.outflow, f.throughput));
}

void FluidStep::declare_impulse_gradient(tasks::StageGraph& graph)
{
    graph.each_block(
        "gradient of pressure impulse",
        [this](LocalBlock b, View<const double> psi, VectorView<double> out) {
            gradient(geometry(b), pressure_matrices(geometry(b), walls_of(b)), psi, out);
        },
        reads(beside(fields_.psi)), writes(fields_.psi_gradient));
}

void FluidStep::declare_old_velocity(tasks::StageGraph& graph)
{
    graph.each_block(
        "remember velocity",
        [](LocalBlock, Vectors u, VectorView<double> before) {
            map_components(
                before, [](double x) { return x; }, u);
        },
        reads(state_.velocity), writes(state_.velocity_before));
}

void FluidStep::declare_correction(tasks::StageGraph& graph)
{
    auto& f = fields_;
    declare_impulse_gradient(graph);
    graph.each_block(
        "correct face flux",
        [this](LocalBlock b, View<const double> psi, Vectors g, FaceView<const double> predicted, FaceView<double> scratch,
               FaceView<double> flux, View<double> removed) {
            map_faces(
                flux, [](double x) { return x; }, predicted);
            correct_flux(geometry(b), walls_of(b), psi, g, scratch, flux);
            net_outflow(scratch, removed);
        },
        reads(beside(f.psi), beside(f.psi_gradient), f.predicted_flux), writes(f.face_scratch, state_.flux, f.removed_outflow));
    declare_old_velocity(graph);
    graph.each_block(
        "correct velocity",
        [](LocalBlock, Vectors predicted, Vectors g, VectorView<double> u) {
            map_components(
                u, [](double x, double gradient) { return x - gradient; }, predicted, g);
        },
        reads(f.predicted, f.psi_gradient), writes(state_.velocity));
    declare_end_of_step(graph);
    declare_budget(graph); // of the pressure that has acted
    graph.each_block(
        "correct pressure",
        [this](LocalBlock b, View<const double> psi, View<const double> outflow, const FluidClock& clock, View<double> p) {
            // Rotational form: what implicit viscosity made of the divergence belongs to the pressure (Timmermans, Minev &
            // van de Vosse 1996). Only what the solver removed counts: the rest comes back, and would pile up.
            const double per_psi = parameters_.density / clock.dt;
            const double per_divergence = parameters_.density * parameters_.viscosity * clock.implicit_share();
            map_cells(
                p, [=](double old, double s, double out, double volume) { return old + (per_psi * s - per_divergence * out / volume); }, p,
                psi, outflow, geometry(b).volume.view());
        },
        reads(f.psi, f.removed_outflow, clock_), updates(state_.pressure));
    graph.sink(state_.velocity);
    graph.sink(state_.pressure);
    graph.sink(state_.flux);
}

void FluidStep::declare_budget(tasks::StageGraph& graph)
{
    auto& f = fields_;
    auto& carrier = by_finite_volumes() ? f.middle_flux : state_.flux;
    auto& carried = by_finite_volumes() ? f.middle : state_.velocity_before;
    graph.each_block(
        "momentum budget",
        [this](LocalBlock b, Vectors u, Vectors before, Vectors source, Vectors advected, Vectors gp, Vectors predicted,
               Vectors psi_gradient, View<const double> pressure, View<const double> impulse, FaceView<const double> through,
               Vectors brought, const FaceFactors& factors, const FluidClock& clock, const DriveState& drive, MomentumBudget& budget) {
            const auto sum = [&](Vectors q) { return volume_sum(geometry(b), q); };
            const double dt = clock.dt, per_density = dt / parameters_.density, implicit = clock.implicit_share();
            const double volume = sum_cells([](double v) { return v; }, geometry(b).volume.view());
            budget.before = sum(before);
            budget.after = sum(u);
            const core::Vec3 by_old_walls = through_flow(geometry(b), old_walls_of(b), through, brought);
            budget.through =
                dt * (by_finite_volumes() ? 0.5 * (by_old_walls + through_flow(geometry(b), walls_of(b), through, brought)) : by_old_walls);
            budget.advection = sum(advected) - sum(source) - budget.through;
            budget.drive = dt * volume * mean_acceleration(parameters_.drive, drive, clock.time, dt);
            budget.pressure =
                per_density * wall_push(geometry(b), walls_of(b), pressure, 1) + wall_push(geometry(b), walls_of(b), impulse, 0);
            budget.gradient = -per_density * sum(gp) - sum(psi_gradient) - budget.pressure;
            budget.viscosity = dt * parameters_.viscosity *
                               ((1 - implicit) * wall_friction(geometry(b), old_walls_of(b), before, factors) +
                                implicit * wall_friction(geometry(b), walls_of(b), predicted, factors));
        },
        reads(state_.velocity, state_.velocity_before, f.source, f.advected, f.pressure_gradient, f.predicted, f.psi_gradient,
              state_.pressure, f.psi, carrier, carried, f.viscosity_ratio, clock_, drive_),
        writes(budget_));
    graph.sink(budget_, "budget");
}

} // namespace physics

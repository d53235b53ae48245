// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep, the cells' side: predictor, volume flux of the mixture, projection, correction.
#include "physics/fluid/advection_lcsi.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/flux_memory.hpp"
#include "physics/fluid/projection.hpp"
#include "physics/fluid/sub_face_flux.hpp"
#include "physics/steps/coupled_step.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView, core::View;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;

FluidOwn CoupledStep::own(CellVectors velocity, CellVectors advected, CellVectors pressure_gradient, const StepDrive& at) const
{
    return {velocity, advected, pressure_gradient, drive_of(at.clock, at.state), fluid_.parameters().density, at.clock.dt};
}

void CoupledStep::declare_boundaries(tasks::StageGraph& graph)
{
    for (core::ScalarField* field : {&fields_.fraction, &fields_.mobility, &fields_.known_mobility})
        graph.boundary(*field, "walls of " + field->info().name,
                       [this](LocalBlock b, View<double> q) { mirror_even(fluid_.walls()[std::size_t(b)], 1, q); });
    if (any_boundary(mesh_, fluid_.parameters().boundaries, gives_pressure))
        graph.boundary(fields_.carried, "walls of the flux of the mixture",
                       [this](LocalBlock b, VectorView<double> q) { mirror_velocity(fluid_.walls()[std::size_t(b)], 1, q); });
}

/// The fluxes are the mixture's: what carries the fluid is its part of them.
void CoupledStep::declare_transport(tasks::StageGraph& graph)
{
    graph.each_block(
        "transport velocity beside grains",
        [this](LocalBlock b, FaceView<const double> flux, GrainSumViews sums, VectorView<double> transport) {
            transport_velocity(geometry(b), flux, transport);
            fluid_velocity(transport, sums, transport);
        },
        reads(fluid_.state().flux, fields_.sums), writes(fluid_.fields().transport));
}

/// Of the flux of the mixture at the start of the step: compared with what fluid and grains carry there and then.
void CoupledStep::declare_memory(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "volume flux of the last step",
        [](LocalBlock, Vectors u, GrainSumViews sums, const FluidClock& clock, VectorView<double> carried) {
            if (clock.memory() > 0) mixture_flux(u, sums, carried);
        },
        reads(fluid_.state().velocity, f.sums, clock_), writes(f.carried));
    fluid_.declare_flux_memory(graph, f.carried);
}

/// Viscosity acts on the fluid as it will be, held back by the grains: with the acceleration of the last step. Else
/// walls and slow neighbours would brake what the drive gives a fluid without grains, in a bed hundreds of times too much.
void CoupledStep::declare_expected(tasks::StageGraph& graph)
{
    auto& fluid = fluid_.fields();
    const auto expect = [this](LocalBlock, Vectors advected, Vectors gp, Vectors acceleration, const FluidClock& clock,
                               VectorView<double> out) {
        // The gradient of the pressure went half to what is advected: off it goes.
        const double half = 0.5 * clock.dt / fluid_.parameters().density;
        map_components(
            out, [half, dt = clock.dt](double u, double g, double a) { return u + (half * g + dt * a); }, advected, gp, acceleration);
    };
    graph.each_block("expect velocity beside grains", expect, reads(fluid.advected, fluid.pressure_gradient, fields_.acceleration, clock_),
                     writes(fluid.predicted));
    fluid_.declare_viscous_guess(graph);
    fluid_.declare_old_velocity(graph);
    graph.sink(fluid_.state().velocity_before);
    declare_advected(graph);
}

/// A pass that is repeated: with the acceleration of the pass before it.
void CoupledStep::declare_expected_again(tasks::StageGraph& graph)
{
    auto& fluid = fluid_.fields();
    const auto expect = [](LocalBlock, Vectors advected, Vectors viscous, Vectors acceleration, const FluidClock& clock,
                           VectorView<double> out) {
        map_components(
            out, [dt = clock.dt](double u, double change, double a) { return u - change + dt * a; }, advected, viscous, acceleration);
    };
    graph.each_block("expect velocity beside grains again", expect,
                     reads(fields_.advected, fluid.viscous_change, fields_.acceleration, clock_), writes(fluid.predicted));
    declare_advected(graph);
}

void CoupledStep::declare_advected(tasks::StageGraph& graph)
{
    auto& fluid = fluid_.fields();
    fluid_.declare_implicit_viscosity(graph);
    graph.each_block(
        "advected velocity",
        [](LocalBlock, Vectors predicted, Vectors acceleration, const FluidClock& clock, VectorView<double> advected) {
            map_components(
                advected, [dt = clock.dt](double u, double a) { return u - dt * a; }, predicted, acceleration);
        },
        reads(fluid.predicted, fields_.acceleration, clock_), writes(fields_.advected));
}

void CoupledStep::declare_predictor(tasks::StageGraph& graph, core::FieldBatch<grain_sums>& taken)
{
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    auto& velocity = fluid_.state().velocity;
    graph.each_block(
        "untold change of velocity",
        [](LocalBlock, Vectors u, Vectors advected, Vectors acceleration, const FluidClock& clock, VectorView<double> miss) {
            map_components(
                miss, [dt = clock.dt](double v, double ua, double a) { return v - ua - dt * a; }, u, advected, acceleration);
        },
        reads(velocity, f.advected, f.acceleration, clock_), writes(f.miss));
    graph.each_block(
        "predict with grains",
        [this](LocalBlock, Vectors u, Vectors advected, Vectors gp, const FluidClock& clock, const DriveState& drive, GrainSumViews sums,
               Vectors ledger, Vectors miss, VectorView<double> change) {
            predicted_velocity_change(own(u, advected, gp, {clock, drive}), sums, ledger, miss, change);
        },
        reads(velocity, f.advected, fluid.pressure_gradient, clock_, fluid_.drive(), taken, f.ledger, f.miss), writes(f.change));
    graph.each_block(
        "projection response",
        [this](LocalBlock, GrainSumViews sums, const FluidClock& clock, View<double> response, View<double> mobility) {
            projection_response(sums, parameters_.fluid_density, clock.dt, response, mobility);
        },
        reads(taken, clock_), writes(f.response, f.mobility));
    graph.each_block(
        "mobility on faces",
        [this](LocalBlock b, View<const double> mobility, FaceView<double> faces) { face_mobility(geometry(b), mobility, faces); },
        reads(beside(f.mobility)), writes(face_mobility_));
}

void CoupledStep::declare_volume_flux(tasks::StageGraph& graph, core::FieldBatch<grain_sums>& taken)
{
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    auto& state = fluid_.state();
    graph.each_block(
        "volume flux with grains",
        [this](LocalBlock, Vectors u, Vectors advected, Vectors gp, const FluidClock& clock, const DriveState& drive, GrainSumViews sums,
               Vectors change, Vectors miss, View<double> known, VectorView<double> carried) {
            predicted_volume_flux(own(u, advected, gp, {clock, drive}), sums, change, miss, known, carried);
        },
        reads(state.velocity, f.advected, fluid.pressure_gradient, clock_, fluid_.drive(), taken, f.change, f.miss),
        writes(f.known_mobility, f.carried));
    fluid_.declare_interpolated_flux(graph, f.carried);
    graph.each_block(
        "known pressure on faces",
        [this](LocalBlock b, View<const double> p, Vectors gp, View<const double> known, FaceView<const double> remembered,
               const FluidClock& clock, FaceView<double> known_faces, FaceView<double> scratch, FaceView<double> flux) {
            face_mobility(geometry(b), known, known_faces);
            gradient_flux(geometry(b), p, gp, scratch);
            pressure_wall_flux(geometry(b), fluid_.walls()[std::size_t(b)], p, scratch);
            map_faces(
                flux, [](double q, double m, double s) { return q - m * s; }, flux, known_faces, scratch);
            sum_sub_faces(geometry(b), flux);
            add_remembered(clock.memory(), remembered, flux);
        },
        reads(beside(state.pressure), beside(fluid.pressure_gradient), beside(f.known_mobility), fluid.remembered_flux, clock_),
        writes(known_face_mobility_, fluid.face_scratch), updates(fluid.predicted_flux));
    fluid_.declare_net_outflow(graph);
}

void CoupledStep::declare_projection(tasks::StageGraph& graph)
{
    auto& fluid = fluid_.fields();
    graph.whole(
        "solve pressure with grains",
        [this](tasks::Lane& lane, const core::FaceField& mobility, const core::ScalarField& outflow, const core::ScalarField& through,
               const FluidClock& clock, core::ScalarField& change) {
            return fluid_.pressure_system().solve(lane, mobility, {outflow, through, 1.0 - clock.memory()}, change);
        },
        reads(face_mobility_, fluid.outflow, fluid.throughput, clock_), writes(fluid.psi));
    FlowControl* control = fluid_.flow_control();
    if (control) {
        control->declare_response(graph, face_mobility_);
        control->declare_correction(
            graph, {fluid.throughput, fluid.psi, fluid.predicted_flux, clock_, fluid_.drive(), 1.0 / fluid_.parameters().density});
    }
    fluid_.declare_impulse_gradient(graph);
    graph.each_block(
        "correct face flux with grains",
        [this](LocalBlock b, View<const double> psi, Vectors g, FaceView<const double> mobility, FaceView<const double> predicted,
               FaceView<double> scratch, FaceView<double> flux) {
            gradient_flux(geometry(b), psi, g, scratch);
            pressure_wall_flux(geometry(b), fluid_.walls()[std::size_t(b)], psi, scratch);
            map_faces(
                flux, [](double q, double m, double s) { return q - m * s; }, predicted, mobility, scratch);
            sum_sub_faces(geometry(b), flux);
        },
        reads(beside(fluid.psi), beside(fluid.psi_gradient), face_mobility_, fluid.predicted_flux),
        writes(fluid.face_scratch, fluid_.state().flux));
    if (!control) return;
    graph.each_block(
        "gradient of the drive's correction",
        [this](LocalBlock, const DriveState& drive, VectorView<double> out) {
            const core::Vec3 push = fluid_.parameters().density * drive.correction * drive_direction(fluid_.parameters().drive);
            for (int c = 0; c < 3; ++c)
                map_cells(
                    out.component(c), [p = push[c]](double g) { return g - p; }, out.component(c));
        },
        reads(fluid_.drive()), updates(fluid.psi_gradient));
}

void CoupledStep::declare_correction(tasks::StageGraph& graph)
{
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    auto& state = fluid_.state();
    graph.each_block(
        "correct velocity with grains",
        [](LocalBlock, Vectors change, View<const double> response, Vectors gradient, VectorView<double> u) {
            for (int c = 0; c < 3; ++c)
                map_cells(
                    u.component(c), [](double v, double du, double r, double g) { return v + (du - r * g); }, u.component(c),
                    change.component(c), response, gradient.component(c));
        },
        reads(f.change, f.response, fluid.psi_gradient), updates(state.velocity));
    fluid_.declare_end_of_step(graph);
    graph.each_block(
        "acceleration of fluid",
        [](LocalBlock, Vectors u, Vectors advected, const FluidClock& clock, VectorView<double> out) {
            map_components(
                out, [per_dt = 1.0 / clock.dt](double v, double a) { return per_dt * (v - a); }, u, advected);
        },
        reads(state.velocity, f.advected, clock_), writes(f.acceleration));
    graph.each_block(
        "correct pressure with grains",
        [](LocalBlock, View<const double> change, View<double> p) {
            map_cells(
                p, [](double old, double d) { return old + d; }, p, change);
        },
        reads(fluid.psi), updates(state.pressure));
    graph.sink(f.acceleration);
    graph.sink(state.pressure);
    graph.sink(state.flux);
}

void CoupledStep::declare_fraction(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "fluid fraction",
        [](LocalBlock, GrainSumViews sums, View<double> fraction, View<double> before) {
            map_cells(
                before, [](double phi) { return phi; }, fraction);
            map_cells(
                fraction, [](double c) { return 1.0 - c; }, sums[sum_solid]);
        },
        reads(f.sums), updates(f.fraction), writes(f.fraction_before));
    graph.sink(f.fraction);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// FluidStep: how the flow carries its velocity, from departure points or by fluxes through faces.
#include "physics/fluid/advection_lcsi.hpp"
#include "physics/fluid/boundary_paths.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/quasi_monotone.hpp"
#include "physics/fluid/sub_face_momentum.hpp"
#include "physics/steps/fluid_step.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView;
using tasks::beside, tasks::halo, tasks::reads, tasks::updates, tasks::writes;

void FluidStep::prepare_advection()
{
    if (!by_finite_volumes()) {
        for (const core::BlockId b : mesh_.own()) singular_axes_.push_back(singular_axes(mesh_.topology(), b));
        return;
    }
    for (const core::BlockId b : mesh_.own()) face_centres_.push_back(face_centres(mesh_.vertices(b)));
    state_.flux_before.allocate();
}

void FluidStep::declare_advection(tasks::StageGraph& graph)
{
    declare_source(graph);
    if (by_finite_volumes()) declare_finite_volumes(graph);
    else declare_departure(graph);
}

void FluidStep::declare_source(tasks::StageGraph& graph)
{
    auto& f = fields_;
    if (viscosity_system_)
        graph.each_block(
            "velocity to advect",
            [this](LocalBlock, Vectors u, Vectors gp, Vectors viscous, const FluidClock& clock, VectorView<double> q) {
                const double half = 0.5 * clock.dt / parameters_.density, share = clock.dt * (1 - clock.implicit_share());
                map_components(
                    q, [=](double v, double g, double a) { return v + (share * a - half * g); }, u, gp, viscous);
            },
            reads(state_.velocity, f.pressure_gradient, f.viscous, clock_), writes(f.source));
    else
        graph.each_block(
            "velocity to advect",
            [this](LocalBlock, Vectors u, Vectors gp, const FluidClock& clock, VectorView<double> q) {
                const double half = 0.5 * clock.dt / parameters_.density;
                map_components(
                    q, [=](double v, double g) { return v - half * g; }, u, gp);
            },
            reads(state_.velocity, f.pressure_gradient, clock_), writes(f.source));
}

void FluidStep::declare_departure(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "velocity in index space",
        [this](LocalBlock b, Vectors transport, Vectors u, Vectors before, const FluidClock& clock, VectorView<double> out) {
            index_velocity(geometry(b), transport, {u, before, clock.extrapolation()}, out);
        },
        reads(halo(f.transport, 1), halo(state_.velocity, 3), halo(state_.velocity_before, 1), clock_), writes(f.index_velocity));
    graph.each_block(
        "trajectories",
        [this](LocalBlock b, Vectors u, const FluidClock& clock, VectorView<double> out) {
            require_within_reach(trajectories(u, clock.dt, out), mesh_.global(b), clock.dt);
            end_at_boundaries(walls_of(b), out);
        },
        reads(f.index_velocity, clock_), writes(f.displacement));
    const auto by_spline = [this](LocalBlock b, Vectors q, Vectors displacement, VectorView<double> out) {
        advect(geometry(b), q, displacement, singular_axes_[std::size_t(b)], out, Interpolation::spline);
    };
    const auto in_range = [this](LocalBlock b, Vectors q, Vectors displacement, VectorView<double> out) {
        advect(geometry(b), q, displacement, singular_axes_[std::size_t(b)], out);
        keep_in_range(geometry(b), q, displacement, out);
    };
    const auto declare = [&](auto kernel) {
        graph.each_block("advect velocity", kernel, reads(halo(f.source, 3), f.displacement), writes(f.advected));
    };
    if (parameters_.advection == AdvectionScheme::lcsi_spline) declare(by_spline);
    else declare(in_range);
}

void FluidStep::declare_finite_volumes(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "flux in the middle of the step",
        [this](LocalBlock b, FaceView<const double> flux, const FluidClock& clock, FaceView<double> before, FaceView<double> middle) {
            middle_flux(clock.extrapolation(), flux, before, middle);
            require_stable_outflow(largest_outflow_rate(geometry(b), middle), mesh_.global(b), clock.dt);
        },
        reads(state_.flux, clock_), updates(state_.flux_before), writes(f.middle_flux));
    graph.each_block(
        "velocity in the middle of the step",
        [](LocalBlock, Vectors transport, Vectors q, const Gradients& g, const FluidClock& clock, VectorView<double> out) {
            middle_velocity(clock.dt, transport, q, g, out);
        },
        reads(f.transport, f.source, f.velocity_gradient, clock_), writes(f.middle));
    graph.each_block(
        "advect velocity",
        [this](LocalBlock b, Vectors u, Vectors middle, const Gradients& g, FaceView<const double> flux, Vectors q, const FluidClock& clock,
               FaceView<double> scratch, VectorView<double> out) {
            momentum_outflow(momentum_transport(b), flux, {u, middle, g}, scratch, out);
            for (int c = 0; c < 3; ++c)
                map_cells(
                    out.component(c), [dt = clock.dt](double before, double outflow, double v) { return before - dt * outflow / v; },
                    q.component(c), out.component(c), geometry(b).volume.view());
        },
        reads(beside(state_.velocity), beside(f.middle), beside(f.velocity_gradient), f.middle_flux, f.source, clock_),
        writes(f.face_scratch, f.advected));
    if (!mesh_.topology().joints.interfaces.empty()) declare_sub_face_momentum(graph);
}

void FluidStep::declare_sub_face_momentum(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "advect velocity through sub-faces",
        [this](LocalBlock b, FaceView<const double> flux, Vectors middle, const FluidClock& clock, VectorView<double> advected) {
            carry_through_sub_faces(geometry(b), clock.dt, flux, middle, advected);
        },
        reads(f.middle_flux, beside(f.middle), clock_), updates(f.advected));
}

} // namespace physics

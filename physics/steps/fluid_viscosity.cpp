// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// FluidStep: the viscous acceleration of a velocity that is known, with the gradients it follows from.
#include "physics/fluid/transposed_stress.hpp"
#include "physics/fluid/wall_profile.hpp"
#include "physics/steps/fluid_step.hpp"

namespace physics {

using core::FaceView, core::LocalBlock, core::VectorView;
using tasks::beside, tasks::reads, tasks::writes;

void FluidStep::velocity_gradients(LocalBlock b, Vectors u, const core::TensorView<double>& out) const
{
    const FaceFactors factors = std::as_const(fields_).viscosity_ratio.on(b);
    for (int c = 0; c < 3; ++c) velocity_gradient(geometry(b), walls_of(b), factors, u.component(c), out[std::size_t(c)]);
}

void FluidStep::viscous_acceleration(LocalBlock b, Vectors u, const Gradients& gradients, FaceView<double> scratch,
                                     VectorView<double> out) const
{
    const FaceFactors factors = std::as_const(fields_).viscosity_ratio.on(b);
    for (int c = 0; c < 3; ++c) {
        diffusive_inflow(geometry(b), walls_of(b), u.component(c), gradients[std::size_t(c)], factors, {scratch, out.component(c)});
        physics::viscous_acceleration(geometry(b), parameters_.viscosity, out.component(c), out.component(c));
    }
    if (factors) add_transposed_stress({geometry(b), walls_of(b), parameters_.viscosity, gradients, *factors}, 1.0, scratch, out);
}

void FluidStep::declare_velocity_gradients(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.each_block(
        "gradient of velocity", [this](LocalBlock b, Vectors u, const core::TensorView<double>& out) { velocity_gradients(b, u, out); },
        reads(beside(state_.velocity)), writes(f.velocity_gradient));
}

void FluidStep::declare_viscous_acceleration(tasks::StageGraph& graph, core::VectorField& acceleration)
{
    constexpr const char* name = "viscous acceleration";
    auto& f = fields_;
    if (!viscosity_needs_gradients()) {
        graph.each_block(
            name,
            [this](LocalBlock b, Vectors u, FaceView<double> scratch, VectorView<double> out) {
                viscous_acceleration(b, u, {}, scratch, out);
            },
            reads(beside(state_.velocity)), writes(f.face_scratch, acceleration));
        return;
    }
    graph.each_block(
        name,
        [this](LocalBlock b, Vectors u, const Gradients& g, const FaceFactors&, FaceView<double> scratch, VectorView<double> out) {
            viscous_acceleration(b, u, g, scratch, out);
        },
        reads(beside(state_.velocity), beside(f.velocity_gradient), f.viscosity_ratio), writes(f.face_scratch, acceleration));
}

tasks::Job FluidStep::find_velocity_gradients(tasks::Lane& lane)
{
    auto& f = fields_;
    co_await halos_.fill(lane, &state_.velocity, core::beside);
    f.velocity_gradient.allocate();
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        mirror_velocity(old_walls_of(b), 1, state_.velocity.on(b)); // between steps, begin_step() has been called
        velocity_gradients(b, state_.velocity.on(b), f.velocity_gradient.on(b));
    }
}

tasks::Job FluidStep::find_viscous_acceleration(tasks::Lane& lane, core::VectorField& acceleration)
{
    auto& f = fields_;
    f.face_scratch.allocate();
    acceleration.allocate();
    co_await halos_.fill(lane, &f.velocity_gradient, core::beside);
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b)
        viscous_acceleration(b, state_.velocity.on(b), std::as_const(f.velocity_gradient).on(b), f.face_scratch.on(b), acceleration.on(b));
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/fluid_views.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/steps/batch_filter.hpp"

namespace physics {
namespace {

/// Three of the views, from `first` on.
core::VectorView<double> vector_of(std::span<const core::View<double>> views, std::size_t first)
{
    return {views[first], views[first + 1], views[first + 2]};
}

} // namespace

using core::LocalBlock, core::VectorView, core::View;
using tasks::beside, tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;

FluidViews::FluidViews(const core::Mesh& mesh, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid,
                       ExchangeFields& fields, const CouplingParameters& parameters)
    : mesh_(mesh),
      halos_(halos),
      fluid_(fluid),
      fields_(fields),
      spins_(parameters.lift || parameters.shear_lift || parameters.torque),
      plan_(mesh_, ranks, 1, 1, core::HaloShape::hats)
{
    fields_.acceleration.allocate();
    fields_.told.allocate();
    halos_.prepare(&fluid_.state().pressure, core::beside);
    halos_.prepare(&fluid_.state().velocity, core::beside);
    halos_.prepare(&fluid_.fields().velocity_gradient, core::beside);
}

void FluidViews::view_state(LocalBlock b, Vectors u, View<const double> p, Vectors acceleration, std::span<const View<double>> out) const
{
    const auto force = vector_of(out, view_pressure_force);
    map_components(
        vector_of(out, view_velocity), [](double x) { return x; }, u);
    gradient(mesh_.geometry(b), pressure_matrices(mesh_.geometry(b), fluid_.walls()[std::size_t(b)]), p, force);
    map_components(
        force, [](double x) { return -x; }, force);
    map_components(
        vector_of(out, view_acceleration), [](double x) { return x; }, acceleration);
}

void FluidViews::view_stress_in(std::span<const View<double>> out, Vectors viscous) const
{
    map_components(
        vector_of(out, 0), [rho = fluid_.parameters().density](double a) { return rho * a; }, viscous);
}

tasks::Job FluidViews::tell_state(tasks::Lane& lane, Filter& filter)
{
    FluidState& state = fluid_.state();
    co_await halos_.fill(lane, &state.pressure, core::beside);
    if (viscous() || spins_ || fluid_.by_finite_volumes()) co_await fluid_.find_velocity_gradients(lane);
    if (viscous()) co_await fluid_.find_viscous_acceleration(lane, fields_.viscous);
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        const auto told = fields_.told.on(b);
        mirror_pressure(fluid_.walls()[std::size_t(b)], 1, state.pressure.on(b));
        view_state(b, state.velocity.on(b), state.pressure.on(b), fields_.acceleration.on(b), told);
        if (viscous()) view_stress_in(std::span(told).subspan(view_stress), fields_.viscous.on(b));
    }
    co_await filter_batch(lane, filter, fields_.told);
    co_await fill_for_sampling(lane, mesh_, plan_, fields_.told);
}

void FluidViews::declare_viscosity(tasks::StageGraph& graph)
{
    if (!viscous()) return;
    graph.each_block(
        "viscous acceleration of the old velocity",
        [](LocalBlock, Vectors known, VectorView<double> acceleration) {
            map_components(
                acceleration, [](double a) { return a; }, known);
        },
        reads(fields_.viscous), writes(fluid_.fields().viscous));
}

void FluidViews::declare_vorticity(tasks::StageGraph& graph)
{
    if (!spins_) return;
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    graph.each_block(
        "vorticity for grains",
        [](LocalBlock, const core::TensorView<const double>& g, std::array<View<double>, 3> curl) {
            vorticity(g[0], g[1], g[2], vector_of(curl, 0));
        },
        reads(fluid.velocity_gradient), writes(f.vorticity));
    graph.whole(
        "halo of vorticity for grains",
        [this](tasks::Lane& lane, core::FieldBatch<3>& curl) { return fill_for_sampling(lane, mesh_, plan_, curl); }, updates(f.vorticity));
}

void FluidViews::declare_state(tasks::StageGraph& graph)
{
    auto& state = fluid_.state();
    graph.each_block(
        "answer for grains",
        [this](LocalBlock b, Vectors u, View<const double> p, Vectors acceleration, std::array<View<double>, grain_news> news) {
            view_state(b, u, p, acceleration, news);
        },
        reads(state.velocity, beside(state.pressure), fields_.acceleration), writes(fields_.news));
}

void FluidViews::declare_filtered(tasks::StageGraph& graph, LaneFilter& filter, Stress stress)
{
    auto& f = fields_;
    if (tells_stress(stress) || spins_ || (fluid_.by_finite_volumes() && stress == Stress::of_new_state))
        fluid_.declare_velocity_gradients(graph);
    if (tells_stress(stress)) {
        fluid_.declare_viscous_acceleration(graph, f.viscous);
        graph.each_block(
            "viscous stress for grains",
            [this](LocalBlock, Vectors viscous, std::array<View<double>, grain_news> news) {
                view_stress_in(std::span(news).subspan(news_stress), viscous);
            },
            reads(f.viscous), updates(f.news));
    }
    graph.whole(
        "filter answer for grains",
        [this, arrays = std::size_t(tells_stress(stress) ? grain_news : news_views)](tasks::Lane& lane, core::FieldBatch<grain_news>& news,
                                                                                     Filter& own) -> tasks::Job {
            co_await filter_batch(lane, own, news, arrays);
            co_await fill_for_sampling(lane, mesh_, plan_, news);
        },
        updates(f.news), writes(filter.stage_part));
}

/// No copy, as the news mean nothing any more. Through all passes of a step the stress is that of its start.
void FluidViews::declare_told(tasks::StageGraph& graph, Stress stress)
{
    graph.whole(
        "tell grains",
        [this, with_stress = tells_stress(stress)](tasks::Lane&, core::FieldBatch<grain_news>& news, core::FieldBatch<told_views>& told) {
            for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
                for (std::size_t a = 0; a < state_views; ++a) std::swap(told.data(b, a), news.data(b, a));
                for (std::size_t a = 0; with_stress && a < 3; ++a) std::swap(told.data(b, view_stress + a), news.data(b, news_stress + a));
            }
        },
        updates(fields_.news, fields_.told));
}

void FluidViews::declare_owed(tasks::StageGraph& graph, const GrainLane& lane)
{
    graph.whole(
        "owe grains",
        [this, &exchange = lane.exchange](tasks::Lane& own, const core::FieldBatch<told_views>& told,
                                          const core::FieldBatch<grain_news>& news, const GrainPlaces& places, const GrainHolds& holds,
                                          const FluidClock& clock, const DriveState& drive, ParticleDynamics& grains) {
            const auto count = std::size_t(grains.particles.owned);
            const GrainTable before = sample(own.team(), places, count, told);
            GrainTable after = sample(own.team(), places, count, news);
            add_correction(drive, after);
            exchange.owe(grains.particles, {before, holds, clock.dt}, after);
        },
        reads(fields_.told, fields_.news, lane.places, lane.holds, lane.clock, fluid_.drive()), updates(lane.grains));
    graph.sink(lane.grains);
}

/// What the drive was found to be beyond what grains were told pushes them like the pressure.
void FluidViews::add_correction(const DriveState& drive, GrainTable& views) const
{
    if (drive.correction == 0) return;
    const core::Vec3 force = fluid_.parameters().density * drive.correction * drive_direction(fluid_.parameters().drive);
    for (int a = 0; a < 3; ++a)
        for (double& x : views[view_pressure_force + std::size_t(a)]) x += force[a];
}

} // namespace physics

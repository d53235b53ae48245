// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep, what grains see of the fluid: the state that they are told, and the answer to what they did.
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/coupled_step.hpp"

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

void CoupledStep::view_state(LocalBlock b, Vectors u, View<const double> p, Vectors acceleration, std::span<const View<double>> out) const
{
    const auto force = vector_of(out, view_pressure_force);
    map_components(
        vector_of(out, view_velocity), [](double x) { return x; }, u);
    gradient(geometry(b), pressure_matrices(geometry(b), fluid_.walls()[std::size_t(b)]), p, force);
    map_components(
        force, [](double x) { return -x; }, force);
    map_components(
        vector_of(out, view_acceleration), [](double x) { return x; }, acceleration);
}

void CoupledStep::view_stress_in(std::span<const View<double>> out, Vectors viscous) const
{
    map_components(
        vector_of(out, 0), [rho = parameters_.fluid_density](double a) { return rho * a; }, viscous);
}

tasks::Job CoupledStep::tell_state(tasks::Lane& lane)
{
    FluidState& state = fluid_.state();
    co_await halos_.fill(lane, &state.pressure, core::beside);
    if (viscous() || spins() || fluid_.by_finite_volumes()) co_await fluid_.find_velocity_gradients(lane);
    if (viscous()) co_await fluid_.find_viscous_acceleration(lane, fields_.viscous);
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        const auto told = fields_.told.on(b);
        mirror_pressure(fluid_.walls()[std::size_t(b)], 1, state.pressure.on(b));
        view_state(b, state.velocity.on(b), state.pressure.on(b), fields_.acceleration.on(b), told);
        if (viscous()) view_stress_in(std::span(told).subspan(view_stress), fields_.viscous.on(b));
    }
    co_await filter_batch(lane, filter_.own, fields_.told);
    co_await fill_for_sampling(lane, mesh_, plan_, fields_.told);
}

/// The viscous acceleration was found when the last step told the grains of it.
void CoupledStep::declare_viscosity(tasks::StageGraph& graph)
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

void CoupledStep::declare_vorticity(tasks::StageGraph& graph)
{
    if (!spins()) return;
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

/// The new state as the grains see it.
void CoupledStep::declare_answer(tasks::StageGraph& graph, Mode mode, Pass pass)
{
    const auto lane = graph.lane(waits_for_grains(mode) ? "particles" : "fluid");
    LaneFilter& lane_filter = waits_for_grains(mode) ? filter_ : *fluid_filter_;
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    auto& state = fluid_.state();
    graph.each_block(
        "answer for grains",
        [this](LocalBlock b, Vectors u, View<const double> p, Vectors acceleration, View<const double> response, Vectors psi_gradient,
               std::array<View<double>, grain_news> news) {
            view_state(b, u, p, acceleration, news);
            for (int c = 0; c < 3; ++c)
                map_cells(
                    news[news_projection + std::size_t(c)], [](double r, double g) { return -r * g; }, response, psi_gradient.component(c));
        },
        reads(state.velocity, beside(state.pressure), f.acceleration, f.response, fluid.psi_gradient), writes(f.news));
    if (tells_stress(pass) || spins() || (fluid_.by_finite_volumes() && pass == Pass::last)) fluid_.declare_velocity_gradients(graph);
    if (tells_stress(pass)) {
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
        [this, arrays = std::size_t(tells_stress(pass) ? grain_news : news_views)](tasks::Lane& lane, core::FieldBatch<grain_news>& news,
                                                                                   Filter& filter) -> tasks::Job {
            co_await filter_batch(lane, filter, news, arrays);
            co_await fill_for_sampling(lane, mesh_, plan_, news);
        },
        updates(f.news), writes(lane_filter.stage_part));
}

/// What the next pass, or the next step, tells the grains: no copy, as the news mean nothing any more. Through all passes of a step
/// the stress is that of its start.
void CoupledStep::declare_told(tasks::StageGraph& graph, Pass pass)
{
    graph.whole(
        "tell grains",
        [this, stress = tells_stress(pass)](tasks::Lane&, core::FieldBatch<grain_news>& news, core::FieldBatch<told_views>& told) {
            for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
                for (std::size_t a = 0; a < state_views; ++a) std::swap(told.data(b, a), news.data(b, a));
                for (std::size_t a = 0; stress && a < 3; ++a) std::swap(told.data(b, view_stress + a), news.data(b, news_stress + a));
            }
        },
        updates(fields_.news, fields_.told));
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/one_way_step.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/mesh_links.hpp"
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/grain_job.hpp"

namespace physics {

using core::LocalBlock, core::VectorView, core::View;
using tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;
using Stress = FluidViews::Stress;

OneWayStep::OneWayStep(const core::Locator& locator, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid,
                       ParticleDynamics& grains, ParticleStepper& stepper, const CouplingParameters& parameters)
    : mesh_(locator.mesh()),
      ranks_(ranks),
      locator_(locator),
      fluid_(fluid),
      stepper_(stepper),
      fields_(mesh_),
      views_(mesh_, ranks, halos, fluid, fields_, parameters),
      exchange_(parameters, add_wet_columns(grains.particles), add_exchange_columns(grains.particles, parameters)),
      filter_("filter", make_mesh_links(mesh_, ranks.rank()).topology, parameters.filter_width),
      dynamics_(grains),
      grains_("grains", grains),
      clock_("fluid clock", fluid.state().clock),
      places_("places of grains"),
      holds_("hold of grains")
{
}

void OneWayStep::declare(tasks::StageGraph& graph, const StepCompany& company)
{
    fluid_.declare_boundaries(graph);
    {
        const auto lane = graph.lane("fluid");
        if (company.before) company.before(graph);
        fluid_.declare_expected_drive(graph);
        views_.declare_viscosity(graph);
    }
    declare_grains(graph);
    {
        const auto lane = graph.lane("fluid");
        fluid_.declare_pressure_gradient(graph);
        fluid_.declare_transport(graph);
        fluid_.declare_predictor(graph);
        fluid_.declare_projection(graph);
        if (company.after) company.after(graph);
        declare_answer(graph);
    }
    const auto lane = graph.lane("particles");
    views_.declare_owed(graph, {exchange_, grains_, places_, holds_, clock_});
    views_.declare_told(graph, Stress::of_new_state);
}

void OneWayStep::declare_grains(tasks::StageGraph& graph)
{
    const auto lane = graph.lane("particles");
    views_.declare_vorticity(graph);
    views_.declare_stirring(graph, {exchange_, grains_, places_, holds_, clock_});
    graph.whole(
        "load grains",
        [this](tasks::Lane& own, const core::FieldBatch<told_views>& told, const core::FieldBatch<3>& vorticity, const FluidClock& clock,
               const DriveState& state, const GrainPlaces& places, ParticleDynamics& grains) {
            const auto count = std::size_t(grains.particles.owned);
            GrainTable table = views_.sample(own.team(), places, count, told, vorticity);
            const GrainStep step{clock.dt, grains.step(), clock.dt_before, 1.0 - clock.memory()};
            exchange_.remember_told(grains.particles, table);
            exchange_.add_fluctuations(grains.particles, table);
            exchange_.freeze_drag(grains.particles, table, {std::vector<double>(count, 1.0), {}, {}}, step);
            exchange_.load(grains.particles, table, expected_acceleration(fluid_.parameters().drive, state, clock.time, clock.dt), step);
        },
        reads(fields_.told, fields_.vorticity, clock_, fluid_.drive(), places_), updates(grains_));
    graph.whole(
        "move grains",
        [this](tasks::Lane& own, const FluidClock& clock, ParticleDynamics&) {
            return move_grains(own, stepper_, WetMotion{exchange_.wet_columns()}, sub_steps, clock.time);
        },
        reads(clock_), updates(grains_));
    graph.whole(
        "find grains",
        [this](tasks::Lane& own, const ParticleDynamics& grains, GrainPlaces& places, GrainHolds& holds) -> tasks::Job {
            own.attempt([&] { find_grains(grains, places, holds); });
            co_await own.agree();
        },
        reads(grains_), updates(places_, holds_));
}

void OneWayStep::find_grains(const ParticleDynamics& grains, GrainPlaces& places, GrainHolds& holds) const
{
    places.locate(mesh_, locator_, grains.domain(), grains.particles);
    holds.find(grains.particles.id, places, exchange_.impulses(grains.particles));
}

core::Vec3 OneWayStep::correction_of(const DriveState& drive) const
{
    return drive.correction * drive_direction(fluid_.parameters().drive);
}

/// The fluid is alone: pressure and drive are all that accelerates it beside viscosity, which grains are told of by the stress.
void OneWayStep::declare_answer(tasks::StageGraph& graph)
{
    auto& fluid = fluid_.fields();
    graph.each_block(
        "acceleration of fluid",
        [this](LocalBlock, Vectors gp, Vectors psi_gradient, const FluidClock& clock, const DriveState& state, VectorView<double> out) {
            const core::Vec3 drive = expected_acceleration(fluid_.parameters().drive, state, clock.time, clock.dt) + correction_of(state);
            for (int c = 0; c < 3; ++c)
                map_cells(
                    out.component(c),
                    [per_density = 1.0 / fluid_.parameters().density, per_dt = 1.0 / clock.dt, push = drive[c]](double g, double change) {
                        return push - per_density * g - per_dt * change;
                    },
                    gp.component(c), psi_gradient.component(c));
        },
        reads(fluid.pressure_gradient, fluid.psi_gradient, clock_, fluid_.drive()), writes(fields_.acceleration));
    graph.sink(fields_.acceleration);
    views_.declare_state(graph);
    graph.each_block(
        "projection for grains",
        [this](LocalBlock, Vectors psi_gradient, const FluidClock& clock, const DriveState& state,
               std::array<View<double>, grain_news> news) {
            const core::Vec3 gain = clock.dt * correction_of(state);
            for (int c = 0; c < 3; ++c)
                map_cells(
                    news[news_projection + std::size_t(c)], [push = gain[c]](double change) { return push - change; },
                    psi_gradient.component(c));
        },
        reads(fluid.psi_gradient, clock_, fluid_.drive()), updates(fields_.news));
    views_.declare_filtered(graph, filter_, Stress::of_new_state);
}

tasks::Job OneWayStep::initialise(tasks::Lane& lane)
{
    co_await set_up_on_mesh(lane, filter_.own, mesh_, ranks_.rank());
    lane.attempt([&] { find_grains(dynamics_, places_.get(), holds_.get()); });
    co_await lane.agree();
    co_await views_.tell_state(lane, filter_.own);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep, the grains' side: loads, sub-steps, sums and what grains are owed.
#include "physics/steps/coupled_step.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/grain_job.hpp"

namespace physics {

using core::LocalBlock, core::VectorView, core::View;
using tasks::halo, tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;

CoupledStep::CoupledStep(const core::Mesh& mesh, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid,
                         ParticleDynamics& grains, ParticleStepper& stepper, const CouplingParameters& parameters)
    : mesh_(mesh), ranks_(ranks), fluid_(fluid), dynamics_(grains), stepper_(stepper), parameters_(parameters), locator_(mesh),
      plan_(mesh, ranks, 1, 1, core::HaloShape::full), fields_(mesh),
      exchange_(parameters, add_wet_columns(grains.particles), add_exchange_columns(grains.particles)),
      pressure_({mesh, fluid.walls(), halos}, ranks, fluid.parameters().tolerances),
      filter_(make_mesh_links(mesh, ranks.rank(), BehindWalls::nothing).topology, {parameters.filter_width}),
      face_mobility_({"mobility on faces", "m3 s/kg", 0, false}, mesh.own_cells()),
      known_face_mobility_({"mobility of the known pressure on faces", "m3 s/kg", 0, false}, mesh.own_cells()),
      grains_("grains", grains), clock_("fluid clock", fluid.state().clock), places_("places of grains"), kept_("grains at the start")
{
    fields_.fraction.allocate();
    fields_.acceleration.allocate();
    fields_.ledger.allocate();
    fields_.sums.allocate();
}

core::Vec3 CoupledStep::drive_of(const FluidClock& clock) const
{
    return mean_acceleration(fluid_.parameters().drive, clock.drive, clock.time, clock.dt);
}

void CoupledStep::declare(tasks::StageGraph& graph, Mode mode)
{
    const int passes = mode == Mode::iterated ? passes_of_iterated : 1;
    declare_boundaries(graph);
    fluid_.declare_boundaries(graph);
    for (int pass = 0; pass < passes; ++pass) {
        if (pass == 0) {
            const auto lane = graph.lane("fluid");
            fluid_.declare_explicit(graph);
            declare_memory(graph);
        } else declare_gradient(graph);
        {
            const auto lane = graph.lane("particles");
            declare_views(graph);
            if (pass == 0) declare_grain_load(graph);
            else declare_restart_of_grains(graph);
            declare_grain_sums(graph);
        }
        const auto lane = graph.lane("fluid");
        if (pass == 0) {
            fluid_.declare_predictor(graph);
            declare_advected(graph);
        }
        declare_predictor(graph);
        declare_volume_flux(graph);
        declare_projection(graph);
        declare_correction(graph);
    }
    const auto lane = graph.lane("particles");
    declare_fraction(graph);
    declare_answer(graph);
}

/// Of the pressure that the last pass found.
void CoupledStep::declare_gradient(tasks::StageGraph& graph)
{
    const auto lane = graph.lane("fluid");
    graph.each_block(
        "gradient of told pressure",
        [this](LocalBlock b, View<const double> p, VectorView<double> gp) { gradient(geometry(b), geometry(b).gradient, p, gp); },
        reads(halo(fluid_.state().pressure, 1)), writes(fluid_.fields().pressure_gradient));
}

/// What the grains are told: state n, or what the last pass found.
void CoupledStep::declare_views(tasks::StageGraph& graph)
{
    auto& f = fields_;
    auto& state = fluid_.state();
    graph.each_block(
        "fluid for grains",
        [this](LocalBlock b, Vectors u, View<const double> p, Vectors acceleration, VectorView<double> scratch,
               std::array<View<double>, grain_views> views) {
            const auto vector = [&](std::size_t first) { return VectorView<double>{views[first], views[first + 1], views[first + 2]}; };
            map_components(vector(view_velocity), [](double x) { return x; }, u);
            map_components(vector(view_acceleration), [](double x) { return x; }, acceleration);
            gradient(geometry(b), geometry(b).gradient, p, vector(view_force));
            map_components(vector(view_force), [](double x) { return -x; }, vector(view_force));
            vorticity(geometry(b), u, scratch, vector(view_vorticity));
        },
        reads(halo(state.velocity, 3), halo(state.pressure, 1), f.acceleration), writes(f.gradient, f.views));
    if (fluid_.viscosity_system())
        graph.each_block(
            "viscous stress for grains",
            [rho = parameters_.fluid_density](LocalBlock, Vectors viscous, std::array<View<double>, grain_views> views) {
                for (int c = 0; c < 3; ++c) {
                    const auto force = views[view_force + std::size_t(c)];
                    map_cells(force, [rho](double g, double a) { return g + rho * a; }, force, viscous.component(c));
                }
            },
            reads(fluid_.fields().viscous), updates(f.views));
    graph.whole(
        "filter fluid for grains",
        [this](tasks::Lane& lane, core::FieldBatch<grain_views>& views) -> tasks::Job {
            co_await filter_batch(lane, filter_, views);
            co_await fill_for_sampling(lane, mesh_, plan_, views);
        },
        updates(f.views));
}

void CoupledStep::declare_grain_load(tasks::StageGraph& graph)
{
    auto& f = fields_;
    graph.whole(
        "load grains",
        [this](tasks::Lane& lane, const core::FieldBatch<grain_views>& views, const core::ScalarField& fraction, const FluidClock& clock,
               const GrainPlaces& places, ParticleDynamics& grains) {
            GrainTable table;
            sample(lane.team(), places, std::size_t(grains.particles.owned), views, table);
            std::vector<double> fractions(std::size_t(grains.particles.owned));
            for (LocalBlock b = 0; b < mesh_.own_count(); ++b) places.sample(b, fraction.on(b), fractions);
            exchange_.freeze_drag(grains.particles, table, fractions);
            exchange_.load(grains.particles, table, drive_of(clock), {clock.dt, grains.step(), 1.0 - clock.memory()});
        },
        reads(f.views, halo(f.fraction, 1), clock_, places_), updates(grains_));
    graph.whole(
        "keep grains",
        [](tasks::Lane&, const ParticleDynamics& grains, GrainState& kept) { kept = {grains.particles, grains.history}; },
        reads(grains_), writes(kept_));
}

void CoupledStep::declare_restart_of_grains(tasks::StageGraph& graph)
{
    graph.whole(
        "load grains again",
        [this](tasks::Lane& lane, const core::FieldBatch<grain_views>& views, const FluidClock& clock, const GrainState& kept,
               GrainPlaces& places, ParticleDynamics& grains) {
            grains.particles = kept.particles;
            grains.history = kept.history;
            places.locate(mesh_, locator_, grains.domain(), grains.particles);
            GrainTable table;
            sample(lane.team(), places, std::size_t(grains.particles.owned), views, table);
            exchange_.load(grains.particles, table, drive_of(clock), {clock.dt, grains.step(), 1.0 - clock.memory()});
        },
        reads(fields_.views, clock_, kept_), updates(places_, grains_));
}

void CoupledStep::declare_grain_sums(tasks::StageGraph& graph)
{
    graph.whole(
        "move grains",
        [this](tasks::Lane& lane, ParticleDynamics&) {
            return move_grains(lane, stepper_, WetMotion{exchange_.wet_columns()}, sub_steps);
        },
        updates(grains_));
    graph.whole(
        "sum over grains",
        [this](tasks::Lane& lane, const ParticleDynamics& grains, const FluidClock& clock, GrainPlaces& places,
               core::FieldBatch<grain_sums>& sums) { return sum_over_grains(lane, grains, clock.dt, places, sums); },
        reads(grains_, clock_), updates(places_), writes(fields_.sums));
}

tasks::Job CoupledStep::sum_over_grains(tasks::Lane& lane, const ParticleDynamics& grains, double dt, GrainPlaces& places,
                                        core::FieldBatch<grain_sums>& sums)
{
    GrainTable deposits;
    lane.attempt([&] {
        places.locate(mesh_, locator_, grains.domain(), grains.particles);
        exchange_.answer(grains.particles, dt, deposits);
    });
    co_await lane.agree();
    lane.team().run(mesh_.own_count(), [&](int b) {
        for (std::size_t a = 0; a < grain_sums; ++a) {
            auto& values = sums.data(b, a);
            std::fill(values.begin(), values.end(), 0.0);
            places.deposit(b, deposits[a], sums.on(b)[a]);
        }
    });
    co_await send_home(lane, mesh_, plan_, sums);
    lane.team().run(mesh_.own_count(), [&](int b) {
        for (const auto& field : sums.on(b)) map_cells(field, [](double q, double volume) { return q / volume; }, field, geometry(b).volume.view());
    });
    co_await filter_batch(lane, filter_, sums);
}

template <std::size_t N>
void CoupledStep::sample(const core::Team& team, const GrainPlaces& places, std::size_t grains, const core::FieldBatch<N>& batch,
                         GrainTable& table) const
{
    table.assign(N, std::vector<double>(grains));
    team.run(mesh_.own_count(), [&](int b) {
        for (std::size_t a = 0; a < N; ++a) places.sample(b, batch.on(b)[a], table[a]);
    });
}

void CoupledStep::declare_answer(tasks::StageGraph& graph)
{
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    graph.each_block(
        "answer for grains",
        [](LocalBlock, Vectors gp, Vectors gradient, Vectors change, View<const double> response, Vectors miss,
           std::array<View<double>, grain_news> news) {
            for (int c = 0; c < 3; ++c) {
                const auto a = std::size_t(c);
                map_cells(news[news_force + a], [](double g, double d) { return -g - d; }, gp.component(c), gradient.component(c));
                map_cells(news[news_force_change + a], [](double d) { return -d; }, gradient.component(c));
                map_cells(news[news_predictor + a], [](double x) { return x; }, change.component(c));
                map_cells(news[news_projection + a], [](double r, double d) { return -r * d; }, response, gradient.component(c));
                map_cells(news[news_miss + a], [](double x) { return x; }, miss.component(c));
            }
        },
        reads(fluid.pressure_gradient, fluid.psi_gradient, f.change, f.response, f.miss), writes(f.news));
    if (fluid_.viscosity_system())
        graph.each_block(
            "viscous answer for grains",
            [rho = parameters_.fluid_density](LocalBlock, Vectors viscous, std::array<View<double>, grain_news> news) {
                for (int c = 0; c < 3; ++c) {
                    const auto force = news[news_force + std::size_t(c)];
                    map_cells(force, [rho](double g, double a) { return g + rho * a; }, force, viscous.component(c));
                }
            },
            reads(fluid.viscous), updates(f.news));
    graph.whole(
        "filter answer for grains",
        [this](tasks::Lane& lane, core::FieldBatch<grain_news>& news) -> tasks::Job {
            co_await filter_batch(lane, filter_, news);
            co_await fill_for_sampling(lane, mesh_, plan_, news);
        },
        updates(f.news));
    graph.whole(
        "owe grains",
        [this](tasks::Lane& lane, const core::FieldBatch<grain_news>& news, const GrainPlaces& places, const FluidClock& clock,
               ParticleDynamics& grains) {
            GrainTable table;
            sample(lane.team(), places, std::size_t(grains.particles.owned), news, table);
            exchange_.owe(grains.particles, table, clock.dt);
        },
        reads(f.news, places_, clock_), updates(grains_));
    graph.sink(grains_);
}

} // namespace physics

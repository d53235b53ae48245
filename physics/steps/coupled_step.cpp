// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep, the grains' side: loads, sub-steps, sums and what grains are owed.
#include "physics/steps/coupled_step.hpp"
#include "core/base/error.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/steps/batch_filter.hpp"
#include "physics/steps/grain_job.hpp"
#include "physics/steps/sum_per_volume.hpp"

namespace physics {

using core::LocalBlock, core::VectorView, core::View;
using tasks::hats, tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;

CoupledStep::CoupledStep(const core::Locator& locator, const core::Communicator& ranks, tasks::HaloFiller& halos, FluidStep& fluid,
                         ParticleDynamics& grains, ParticleStepper& stepper, const CouplingParameters& parameters)
    : mesh_(locator.mesh()),
      ranks_(ranks),
      fluid_(fluid),
      dynamics_(grains),
      stepper_(stepper),
      parameters_(parameters),
      locator_(locator),
      halos_(halos),
      fields_(mesh_),
      views_(mesh_, ranks, halos, fluid, fields_, parameters),
      transport_(mesh_),
      exchange_(parameters, add_wet_columns(grains.particles), add_exchange_columns(grains.particles, parameters)),
      filter_("filter", make_mesh_links(mesh_, ranks.rank()).topology, parameters.filter_width),
      face_mobility_({"mobility on faces", "m3 s/kg", 0, false}, mesh_.own_cells()),
      known_face_mobility_({"mobility of the known pressure on faces", "m3 s/kg", 0, false}, mesh_.own_cells()),
      grains_("grains", grains),
      clock_("fluid clock", fluid.state().clock),
      places_("places of grains"),
      holds_("hold of grains"),
      surface_("surface around grains"),
      kept_("grains at the start"),
      assumed_("assumed grains")
{
    core::require<core::ConfigError>(!mesh_.topology().turns(), "grains cannot pass sides that are joined by a turn yet");
    fields_.fraction.allocate();
    fields_.ledger.allocate();
    fields_.sums.allocate();
    if (parameters_.mixture) fields_.surface.allocate();
    prepare_advection();
}

core::Vec3 CoupledStep::drive_of(const FluidClock& clock, const DriveState& state) const
{
    return expected_acceleration(fluid_.parameters().drive, state, clock.time, clock.dt);
}

void CoupledStep::declare(tasks::StageGraph& graph, Mode mode)
{
    const int passes = mode == Mode::iterated ? passes_of_iterated : 1;
    const bool waits = waits_for_grains(mode);
    if (!waits) make_assumed();
    auto& sums = waits ? fields_.sums : fields_.assumed;
    declare_boundaries(graph);
    fluid_.declare_boundaries(graph);
    for (int pass = 0; pass < passes; ++pass) {
        if (pass == 0) {
            const auto lane = graph.lane("fluid");
            if (company_.before) company_.before(graph);
            fluid_.declare_expected_drive(graph);
            views_.declare_viscosity(graph);
            declare_transport(graph);
            declare_memory(graph);
        }
        {
            const auto lane = graph.lane("fluid");
            if (auto* control = fluid_.flow_control(); control && pass > 0) control->declare_next_pass(graph, fluid_.drive());
            fluid_.declare_pressure_gradient(graph); // that the grains are told
        }
        {
            const auto lane = graph.lane("particles");
            views_.declare_vorticity(graph);
            if (pass == 0) declare_sizes(graph);
            if (pass == 0) declare_grain_load(graph);
            else declare_restart_of_grains(graph);
            if (!waits) declare_taking(graph);
            declare_grain_sums(graph);
            if (pass < passes - 1) declare_memory_of_contacts(graph);
        }
        {
            const auto lane = graph.lane("fluid");
            if (pass == 0) {
                declare_advection(graph);
                declare_expected(graph);
                if (!waits) declare_assumed(graph, mode);
            } else if (views_.viscous()) {
                declare_expected_again(graph);
            }
            declare_predictor(graph, sums);
            declare_volume_flux(graph, sums);
            declare_projection(graph);
            declare_correction(graph);
            if (company_.after && pass == passes - 1) company_.after(graph);
        }
        const Pass kind = pass == passes - 1 ? Pass::last : Pass::followed;
        declare_answer(graph, mode, kind);
        const auto lane = graph.lane("particles");
        if (kind == Pass::last) {
            declare_fraction(graph);
            declare_ledger(graph, mode);
            declare_agreement(graph);
            views_.declare_owed(graph, {exchange_, grains_, places_, holds_, clock_});
            declare_surface(graph);
        }
        views_.declare_told(graph, stress_of(kind));
    }
}

void CoupledStep::declare_grain_load(tasks::StageGraph& graph)
{
    auto& f = fields_;
    views_.declare_stirring(graph, {exchange_, grains_, places_, holds_, clock_});
    graph.whole(
        "load grains",
        [this](tasks::Lane& lane, const core::FieldBatch<told_views>& told, const core::FieldBatch<3>& vorticity,
               const core::ScalarField& fraction, const FluidClock& clock, const DriveState& drive, const GrainPlaces& places,
               const std::vector<double>& surface, ParticleDynamics& grains, GrainHolds& holds) {
            holds.forget();
            GrainTable table = views_.sample(lane.team(), places, std::size_t(grains.particles.owned), told, vorticity);
            GrainSurroundings around = surroundings(places, grains.particles, fraction);
            around.surface = surface;
            exchange_.remember_told(grains.particles, table);
            if (parameters_.own_disturbance) {
                const auto wakes = exchange_.wakes(grains.particles, table, around, clock.dt_before);
                exchange_.remember_wakes(grains.particles, wakes);
                exchange_.take_off(wakes, grains.particles, table, around);
            }
            exchange_.add_fluctuations(grains.particles, table);
            const GrainStep step{clock.dt, grains.step(), clock.dt_before, 1.0 - clock.memory()};
            exchange_.freeze_drag(grains.particles, table, around, step);
            exchange_.load(grains.particles, table, drive_of(clock, drive), step);
        },
        reads(f.told, f.vorticity, hats(f.fraction), clock_, fluid_.drive(), places_, surface_), updates(grains_, holds_));
    graph.whole(
        "keep grains",
        [](tasks::Lane&, const ParticleDynamics& grains, GrainState& kept) {
            kept = {grains.particles, grains.history};
        },
        reads(grains_), writes(kept_));
    declare_resistance(graph);
}

void CoupledStep::declare_resistance(tasks::StageGraph& graph)
{
    if (!resists_turbulence_) return;
    graph.whole(
        "resistance of grains to turbulence",
        [this](tasks::Lane& lane, const ParticleDynamics& grains, const GrainPlaces& places, core::FieldBatch<resisting>& sums) {
            return sum_per_volume(lane, mesh_, views_.plan(), places, exchange_.resistance(grains.particles), sums);
        },
        reads(grains_, places_), writes(fields_.resistance));
}

void CoupledStep::declare_restart_of_grains(tasks::StageGraph& graph)
{
    graph.whole(
        "load grains again",
        [this](tasks::Lane& lane, const core::FieldBatch<told_views>& told, const core::FieldBatch<3>& vorticity,
               const core::ScalarField& fraction, const FluidClock& clock, const DriveState& drive, const std::vector<double>& surface,
               GrainState& kept, GrainPlaces& places, ParticleDynamics& grains) {
            places.locate(mesh_, locator_, grains.domain(), kept.particles);
            GrainTable table = views_.sample(lane.team(), places, std::size_t(kept.particles.owned), told, vorticity);
            GrainSurroundings around = surroundings(places, kept.particles, fraction);
            around.surface = surface;
            exchange_.remember_told(kept.particles, table);
            if (parameters_.own_disturbance) // of this pass alone: the next step begins with the last that was remembered
                exchange_.take_off(exchange_.wakes(kept.particles, table, around, clock.dt), kept.particles, table, around);
            exchange_.add_fluctuations(kept.particles, table);
            exchange_.revise(kept.particles, table, around);
            grains.particles = kept.particles;
            grains.history = kept.history;
            exchange_.load(grains.particles, table, drive_of(clock, drive),
                           {clock.dt, grains.step(), clock.dt_before, 1.0 - clock.memory()});
        },
        reads(fields_.told, fields_.vorticity, hats(fields_.fraction), clock_, fluid_.drive(), surface_), updates(kept_, places_, grains_));
}

GrainSurroundings CoupledStep::surroundings(const GrainPlaces& places, const core::ParticleSet& grains,
                                            const core::ScalarField& fraction) const
{
    const auto count = std::size_t(grains.owned);
    GrainSurroundings around{std::vector<double>(count), {}, {}};
    if (parameters_.own_disturbance) around.spread.resize(count);
    for (LocalBlock b = 0; b < mesh_.own_count(); ++b) {
        places.sample(b, fraction.on(b), around.fraction);
        if (!parameters_.own_disturbance) continue;
        for (const int g : places.in_block(b)) around.spread[std::size_t(g)] = places.spread(g, geometry(b));
    }
    return around;
}

void CoupledStep::declare_grain_sums(tasks::StageGraph& graph)
{
    graph.whole(
        "move grains",
        [this](tasks::Lane& lane, const FluidClock& clock, ParticleDynamics&) {
            return move_grains(lane, stepper_, WetMotion{exchange_.wet_columns()}, sub_steps, clock.time);
        },
        reads(clock_), updates(grains_));
    graph.whole(
        "sum over grains",
        [this](tasks::Lane& lane, const ParticleDynamics& grains, const core::FieldBatch<told_views>& told, const FluidClock& clock,
               GrainPlaces& places, GrainHolds& holds, Filter& filter, core::FieldBatch<grain_sums>& sums) {
            return sum_over_grains(lane, {grains.particles, told, clock.dt, places, holds}, filter, sums);
        },
        reads(grains_, fields_.told, clock_), updates(places_, holds_), writes(filter_.stage_part, fields_.sums));
}

/// For the pass that follows: it sees how far contacts give way to what has changed.
void CoupledStep::declare_memory_of_contacts(tasks::StageGraph& graph)
{
    graph.whole(
        "remember contacts",
        [this](tasks::Lane&, const ParticleDynamics& grains, const GrainPlaces& places, GrainHolds& holds) {
            if (bed_gives_way) holds.remember(grains.particles.id, places);
        },
        reads(grains_, places_), updates(holds_));
}

tasks::Job CoupledStep::sum_over_grains(tasks::Lane& lane, MovedGrains moved, Filter& filter, core::FieldBatch<grain_sums>& sums)
{
    GrainTable deposits;
    GrainPlaces& places = moved.places;
    lane.attempt([&] {
        places.locate(mesh_, locator_, dynamics_.domain(), moved.grains);
        moved.holds.find(moved.grains.id, places, exchange_.impulses(moved.grains));
        GrainTable told(3, std::vector<double>(std::size_t(moved.grains.owned)));
        static_assert(view_velocity == 0); // no other view is needed here
        lane.team().run(mesh_.own_count(), [&](int b) {
            const auto views = moved.told.on(b);
            places.sample(b, std::span(views).first(told.size()), told);
        });
        exchange_.answer(moved.grains, {told, moved.holds, moved.dt}, deposits);
    });
    co_await lane.agree();
    co_await sum_per_volume(lane, mesh_, views_.plan(), places, std::move(deposits), sums);
    co_await filter_batch(lane, filter, sums, exchange_.sums());
}

/// How the fluid has answered: the new state as the grains see it, and how much of it the projection made.
void CoupledStep::declare_answer(tasks::StageGraph& graph, Mode mode, Pass pass)
{
    const auto lane = graph.lane(waits_for_grains(mode) ? "particles" : "fluid");
    views_.declare_state(graph);
    graph.each_block(
        "projection for grains",
        [](LocalBlock, View<const double> response, Vectors psi_gradient, std::array<View<double>, grain_news> news) {
            for (int c = 0; c < 3; ++c)
                map_cells(
                    news[news_projection + std::size_t(c)], [](double r, double g) { return -r * g; }, response, psi_gradient.component(c));
        },
        reads(fields_.response, fluid_.fields().psi_gradient), updates(fields_.news));
    views_.declare_filtered(graph, waits_for_grains(mode) ? filter_ : *fluid_filter_, stress_of(pass));
}

} // namespace physics

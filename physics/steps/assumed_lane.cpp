// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// CoupledStep where the fluid lane does not wait for the grains: what it takes them for, and the ledger of the difference.
#include "physics/coupling/assumed_grains.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/steps/coupled_step.hpp"
#include "physics/steps/grain_job.hpp"

namespace physics {

using core::LocalBlock, core::VectorView, core::View;
using tasks::reads, tasks::updates, tasks::writes;
using Vectors = VectorView<const double>;

/// Dynamics, filter and places of their own: both lanes run at the same time.
void CoupledStep::make_assumed()
{
    if (fluid_filter_) return;
    AssumedGrains& assumed = assumed_.get();
    assumed.dynamics = std::make_unique<ParticleDynamics>(dynamics_);
    assumed.stepper = std::make_unique<ParticleStepper>(*assumed.dynamics, stepper_);
    fluid_filter_ =
        std::make_unique<LaneFilter>("filter of the fluid lane", make_mesh_links(mesh_, ranks_.rank()).topology, parameters_.filter_width);
}

void CoupledStep::declare_taking(tasks::StageGraph& graph)
{
    graph.whole(
        "take grains as loaded",
        [this](tasks::Lane&, const ParticleDynamics& grains, AssumedGrains& assumed) {
            assumed.stepper->give_up(); // the lists of a step that failed
            assumed.dynamics->particles = grains.particles;
            assumed.dynamics->history = grains.history;
        },
        reads(grains_), writes(assumed_));
}

void CoupledStep::declare_assumed(tasks::StageGraph& graph, Mode mode)
{
    if (mode == Mode::coarse)
        graph.whole(
            "move grains with longer sub-steps",
            [this](tasks::Lane& lane, const FluidClock& clock, AssumedGrains& assumed) { return coarse_pass(lane, assumed, clock.time); },
            reads(clock_), updates(assumed_));
    else
        graph.whole(
            "fly grains held back",
            [this](tasks::Lane&, const FluidClock& clock, AssumedGrains& assumed) {
                fly(assumed.dynamics->particles, exchange_.wet_columns(), exchange_.columns().hold, clock.dt, sub_steps);
            },
            reads(clock_), updates(assumed_));
    graph.whole(
        "sum over assumed grains",
        [this](tasks::Lane& lane, const core::FieldBatch<told_views>& told, const FluidClock& clock, AssumedGrains& assumed, Filter& filter,
               core::FieldBatch<grain_sums>& sums) {
            return sum_over_grains(lane, {assumed.dynamics->particles, told, clock.dt, assumed.places, assumed.holds}, filter, sums);
        },
        reads(fields_.told, clock_), updates(assumed_), writes(fluid_filter_->stage_part, fields_.assumed));
}

tasks::Job CoupledStep::coarse_pass(tasks::Lane& lane, AssumedGrains& assumed, double time) const
{
    const int number = (sub_steps + coarsening - 1) / coarsening;
    const double factor = double(sub_steps) / number;
    assumed.dynamics->set_step(factor * dynamics_.step());
    stretch_loads(assumed.dynamics->particles, exchange_.wet_columns(), factor);
    co_await move_grains(lane, *assumed.stepper, WetMotion{exchange_.wet_columns()}, number, time);
}

/// What the fluid is still owed: nothing where it has waited for the grains.
void CoupledStep::declare_ledger(tasks::StageGraph& graph, Mode mode)
{
    auto& f = fields_;
    auto& fluid = fluid_.fields();
    if (waits_for_grains(mode))
        graph.each_block(
            "ledger is paid",
            [](LocalBlock, VectorView<double> ledger) {
                for (int c = 0; c < 3; ++c)
                    core::for_each_cell(ledger.x.extents(), [&](int i, int j, int k) { ledger.component(c)(i, j, k) = 0.0; });
            },
            writes(f.ledger));
    else
        graph.each_block(
            "ledger",
            [this](LocalBlock, Vectors u, Vectors advected, Vectors gp, Vectors gradient, const FluidClock& clock, const DriveState& drive,
                   GrainSumViews sums, Vectors change, View<const double> response, Vectors miss, VectorView<double> ledger) {
                unpaid_impulse(own(u, advected, gp, {clock, drive}), sums, {change, response, gradient, miss}, ledger);
            },
            reads(fluid_.state().velocity, f.advected, fluid.pressure_gradient, fluid.psi_gradient, clock_, fluid_.drive(), f.sums,
                  f.change, f.response, f.miss),
            updates(f.ledger));
    graph.sink(f.ledger);
}

} // namespace physics

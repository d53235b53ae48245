// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/simulation_outputs.hpp"
#include "io/run/state_file.hpp"

namespace io {
namespace {

bool wanted(const Interval& interval) { return interval.clock != Interval::Clock::never; }

} // namespace

SimulationOutputs::SimulationOutputs(World& world, const RunDirectory& directory, Log& log, bool resumed)
    : world_(world),
      directory_(directory),
      log_(log),
      metrics_clock_(world.scene().output.metrics, world.ranks()),
      results_clock_(world.scene().output.results, world.ranks()),
      pictures_clock_(world.scene().output.pictures, world.ranks()),
      checkpoint_clock_(world.scene().output.checkpoint, world.ranks()),
      metrics_(world, directory.metrics(), resumed ? std::optional(world.time()) : std::nullopt)
{
    if (world.grains() && world.scene().measures(GrainMeasure::profile))
        profile_.emplace(world, directory.profile(), resumed ? std::optional(world.time()) : std::nullopt);
    if (wanted(world.scene().output.results)) results_.emplace(world, directory.results().string());
    if (wanted(world.scene().output.pictures)) pictures_.emplace(world, directory.frames());
    checkpoint_clock_.resume(now());
    if (resumed)
        for (IntervalClock* clock : {&metrics_clock_, &results_clock_, &pictures_clock_}) clock->resume(now());
}

Moment SimulationOutputs::now() const { return {world_.time(), world_.clock().step, log_.seconds()}; }

void SimulationOutputs::checkpoint()
{
    if (world_.clock().step == last_saved_step_) return;
    save_state(world_, directory_.checkpoints().string(), world_.scene().output.keep_checkpoints);
    metrics_.flush();
    if (profile_) profile_->flush();
    last_saved_step_ = world_.clock().step;
}

void SimulationOutputs::write_due()
{
    const Moment moment = now();
    if (metrics_clock_.due(moment)) metrics_.write();
    if (results_clock_.due(moment)) {
        results_->write(world_, results_clock_.number());
        if (profile_) profile_->write(world_);
    }
    if (pictures_clock_.due(moment)) {
        pictures_->draw(world_, pictures_clock_.number());
        if (const std::string warning = pictures_->take_warning(); !warning.empty()) log_.warning(warning);
    }
    if (checkpoint_clock_.due(moment)) checkpoint();
}

void SimulationOutputs::after_step()
{
    metrics_.after_step();
    write_due();
}

void SimulationOutputs::finish()
{
    checkpoint();
    if (pictures_) pictures_->finish();
}

StepReport SimulationOutputs::step_report() const
{
    StepReport report;
    report.step = world_.clock().step;
    report.time = world_.time();
    report.time_step = world_.clock().dt;
    report.limit = world_.step_limit();
    if (const auto* grains = world_.grains()) report.particles = grains->particles.owned;
    return report;
}

} // namespace io

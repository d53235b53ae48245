// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/simulation_outputs.hpp"
#include "io/state_file.hpp"

namespace io {

SimulationOutputs::SimulationOutputs(World& world, const RunDirectory& directory, Log& log, bool)
    : world_(world), directory_(directory), log_(log), last_checkpoint_time_(world.time())
{
}

SimulationOutputs::~SimulationOutputs() = default;

bool SimulationOutputs::checkpoint_is_due()
{
    const Interval& interval = world_.scene().output.checkpoint;
    double passed = 0;
    if (interval.clock == Interval::Clock::steps) passed = double(world_.clock().step - std::max<std::int64_t>(0, last_saved_step_));
    if (interval.clock == Interval::Clock::simulated) passed = (world_.time() - last_checkpoint_time_) * (1 + 1e-12);
    if (interval.clock == Interval::Clock::wall) {
        passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - last_checkpoint_).count();
        world_.ranks().max(std::span(&passed, 1)); // all ranks must agree
    }
    return interval.clock != Interval::Clock::never && passed >= interval.every;
}

void SimulationOutputs::checkpoint()
{
    if (world_.clock().step == last_saved_step_) return;
    save_state(world_, directory_.checkpoints(), world_.scene().output.keep_checkpoints);
    last_saved_step_ = world_.clock().step;
    last_checkpoint_ = std::chrono::steady_clock::now();
    last_checkpoint_time_ = world_.time();
}

void SimulationOutputs::write_due()
{
    if (world_.clock().step > 0 && checkpoint_is_due()) checkpoint();
}

void SimulationOutputs::finish() { checkpoint(); }

StepReport SimulationOutputs::step_report() const
{
    StepReport report;
    report.step = world_.clock().step;
    report.time = world_.time();
    report.time_step = world_.clock().dt;
    if (const auto* grains = world_.grains()) report.particles = grains->particles.owned;
    return report;
}

} // namespace io

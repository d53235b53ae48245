// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/simulation.hpp"
#include "core/base/error.hpp"
#include "io/build/grid_builder.hpp"
#include "io/files/rank_zero.hpp"
#include "io/run/manifest.hpp"
#include "io/run/run_cost.hpp"
#include "io/run/simulation_outputs.hpp"
#include "io/run/state_file.hpp"
#include "io/scene/scene_writer.hpp"
#include <fmt/format.h>
#include <fstream>
#include <iostream>

namespace io {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream file(path);
    file << text;
    core::require<core::FileError>(file.good(), fmt::format("{} cannot be written", path.string()));
}

/// @throws core::ConfigError where there are fewer blocks than ranks.
core::MultiBlock blocks_for(const Grid& grid, int ranks)
{
    core::MultiBlock made = make_blocks(grid);
    const std::size_t blocks = made.blocks.size();
    core::require<core::ConfigError>(
        std::size_t(ranks) <= blocks,
        fmt::format("{} ranks, but the grid has only {} block{}: use fewer ranks, or more blocks in the grid of the scene", ranks, blocks,
                    blocks == 1 ? "" : "s"));
    return made;
}

RunDirectory prepare(const Scene& scene, const core::Communicator& ranks, const SimulationOptions& options)
{
    on_rank_zero<core::ConfigError>(ranks, [&] {
        const RunDirectory run = RunDirectory::create(options.directory, options.existing);
        write_text(run.scene(), scene_text(scene));
        write_text(run.manifest(), manifest_text({options.command, ranks.size(), options.threads, options.executor}));
    });
    return RunDirectory(options.directory);
}

std::unique_ptr<core::Team> team_for(const SimulationOptions& options)
{
    if (options.threads == 1) return std::make_unique<core::SerialTeam>();
    return options.executor == "openmp" ? core::make_openmp_team(options.threads) : core::make_tbb_team(options.threads);
}

} // namespace

Simulation::Simulation(const Scene& scene, const core::Communicator& ranks, const SimulationOptions& options)
    : Simulation(scene, blocks_for(scene.grid, ranks.size()), ranks, options)
{
}

Simulation::Simulation(const Scene& scene, core::MultiBlock blocks, const core::Communicator& ranks, const SimulationOptions& options)
    : options_(options),
      ranks_(ranks),
      directory_(prepare(scene, ranks, options)),
      console_(std::cout, console_kind(ranks.rank())),
      log_(ranks.rank() == 0 ? directory_.log() : std::filesystem::path(), console_),
      requests_(directory_.stop_file(), scene.run.wall_clock),
      world_(scene, std::move(blocks), ranks)
{
    if (options.existing == RunDirectory::Existing::resume) resume();
    settle();
    if (early_stop_ != StopReason::none) return;
    const tasks::Plan& plan = world_.compile();
    executor_ = tasks::make_executor({options.executor, options.threads, options.trace ? &trace_ : nullptr}, plan);
    const bool resumed = options.existing == RunDirectory::Existing::resume && world_.clock().step > 0;
    world_.run_other_modes_with({executor_->name(), options.threads, nullptr});
    outputs_ = std::make_unique<SimulationOutputs>(world_, directory_, log_, resumed);
    report_plan();
}

Simulation::~Simulation() = default;

void Simulation::resume()
{
    const CheckpointChoice choice = newest_good_checkpoint(directory_.checkpoints(), ranks_);
    for (const std::string& refused : choice.refused) log_.warning(refused);
    core::require<core::FileError>(!choice.path.empty(), fmt::format("{} has no good checkpoint", directory_.checkpoints().string()));
    load_state(CheckpointReader(choice.path, ranks_), world_);
    log_.info(fmt::format("restart from {} at t = {:.6g} s", choice.path, world_.time()));
}

void Simulation::settle()
{
    const auto team = team_for(options_);
    if (world_.settling_left() > 0)
        log_.info(fmt::format("settling for {:.6g} s: {:.6g} sub-steps of {:.3g} s", world_.scene().run.settle, world_.settling_left(),
                              world_.grains()->step()));
    while (world_.settling_left() > 0) {
        early_stop_ = requests_.agree(ranks_);
        if (early_stop_ != StopReason::none) return;
        world_.settle_batch(*team);
    }
}

StopReason Simulation::stop_early()
{
    save_state(world_, directory_.checkpoints().string(), world_.scene().output.keep_checkpoints);
    log_.info(fmt::format("stopped by {} while the grains settled, {:.6g} of {:.6g} sub-steps done, state saved", name_of(early_stop_),
                          world_.settled(), world_.settled() + world_.settling_left()));
    return early_stop_;
}

void Simulation::report_plan()
{
    log_.info(fmt::format("{}: {} cells in {} blocks, {} ranks x {} threads, executor {}", world_.scene().name, world_.mesh().total_cells(),
                          world_.mesh().blocks(), ranks_.size(), options_.threads, executor_->name()));
    if (world_.coupling())
        log_.info(fmt::format("coupling {}; filter of degree {}", world_.mode_reason(), world_.coupling()->filter_degree()));
    if (world_.one_way()) log_.info(fmt::format("coupling one way; filter of degree {}", world_.one_way()->filter_degree()));
}

void Simulation::step()
{
    try {
        world_.step(*executor_);
    } catch (const core::Error&) {
        log_.warning(fmt::format("the step from t = {:.6g} s failed; saving the state before it", world_.time()));
        try {
            outputs_->finish();
        } catch (const core::Error& another) { // must not hide the first
            log_.warning(another.what());
        }
        throw;
    }
    for (const std::string& warning : world_.take_warnings()) log_.warning(warning);
    for (const std::string& note : world_.take_notes()) log_.info(note);
}

StopReason Simulation::run()
{
    if (early_stop_ != StopReason::none) return stop_early();
    const double until = options_.until.value_or(world_.scene().run.until);
    Progress progress(world_.time(), until, console_, log_);
    StopReason reason = requests_.agree(ranks_); // somebody may have asked during the preparation
    outputs_->write_due();
    while (world_.time() < until * (1 - 1e-12) && reason == StopReason::none) {
        step();
        outputs_->after_step();
        progress.step(outputs_->step_report(), log_.seconds());
        reason = requests_.agree(ranks_);
    }
    progress.finish();
    outputs_->finish();
    if (options_.trace) {
        trace_.write(*world_.plan(), ranks_.rank(), directory_.trace(ranks_.rank()));
        for (const std::string& line : trace_lines(trace_.digest(*world_.plan()), ranks_)) log_.info(line);
    }
    if (world_.coupling()) log_.info(fmt::format("coupling: {}; the last, {}", world_.mode_counts(), world_.mode_reason()));
    log_.info(memory_line(world_));
    if (reason != StopReason::none) log_.info(fmt::format("stopped by {} at t = {:.6g} s, state saved", name_of(reason), world_.time()));
    else
        log_.info(fmt::format("finished at t = {:.6g} s after {} steps in {}", world_.time(), world_.clock().step,
                              duration_text(log_.seconds())));
    return reason;
}

} // namespace io

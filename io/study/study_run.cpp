// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/study_run.hpp"
#include "core/base/team.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <variant>

namespace io {
namespace {

double processor_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Adds the time between start() and stop().
class StopWatch {
public:
    void start()
    {
        wall_start_ = std::chrono::steady_clock::now();
        processor_start_ = processor_seconds();
    }
    void stop()
    {
        wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
        processor += processor_seconds() - processor_start_;
    }
    double wall = 0, processor = 0;

private:
    std::chrono::steady_clock::time_point wall_start_;
    double processor_start_ = 0;
};

using Meter = std::variant<WomersleyError, SampledCurves>;

Meter meter_for(World& world, const Study& study)
{
    if (study.error == StudyError::womersley) return WomersleyError(world, study.periods);
    return SampledCurves(world);
}

/// Edge of a cell where the flow varies: over the section of a pipe, over the volume of a box [m].
double cell_size(const World& world)
{
    const double cells = double(world.mesh().total_cells()), volume = world.mesh().total_volume();
    if (!world.scene().grid.pipe) return std::cbrt(volume / cells);
    const PipeGrid& pipe = *world.scene().grid.pipe;
    return std::sqrt(volume / pipe.length / (cells / pipe.chosen_cells().along));
}

double iterations_of(World& world) { return world.fluid() ? world.fluid()->pressure_system().report().iterations : 0.0; }

StudyRun run_once(const Study& study, const StudyCase& one, const core::Communicator& ranks, const StudyResources& resources)
{
    World world(one.scene, ranks);
    world.settle(core::SerialTeam());
    const tasks::ExecutorOptions options{resources.executor, resources.threads, nullptr};
    world.run_other_modes_with(options);
    const auto executor = tasks::make_executor(options, world.compile());
    Meter meter = meter_for(world, study);
    StudyRun run;
    run.choice = one.choice;
    run.labels = one.labels;
    run.ranks = ranks.size();
    run.threads = resources.threads;
    const bool ensemble = study.error == StudyError::ensemble;
    const std::vector<MetricGroup> groups = ensemble ? state_metrics(world) : std::vector<MetricGroup>{};
    for (const MetricGroup& group : groups) run.metrics.insert(run.metrics.end(), group.names.begin(), group.names.end());
    run.at_start = values_of(groups);
    StopWatch watch;
    const double until = one.scene.run.until * (1 - 1e-9);
    while (world.time() < until) {
        watch.start();
        world.step(*executor);
        watch.stop();
        run.iterations += iterations_of(world);
        std::visit([](auto& m) { m.after_step(); }, meter);
        for (std::string& warning : world.take_warnings()) run.warnings.push_back(std::move(warning));
    }
    run.at_the_end = values_of(groups);
    run.steps = long(world.clock().step);
    run.cells = world.mesh().total_cells();
    for (const Species& s : one.scene.particles) run.particles += s.count.value_or(0);
    run.h = cell_size(world);
    run.dt = world.time() / double(run.steps);
    run.iterations /= double(run.steps);
    run.tolerance = one.scene.solver.tolerance;
    double times[2] = {watch.processor, watch.wall};
    ranks.sum(std::span(times, 1));
    ranks.max(std::span(times + 1, 1));
    run.processor = times[0];
    run.wall = times[1];
    run.trace = std::visit([](const auto& m) { return m.trace(); }, meter);
    if (const auto* exact = std::get_if<WomersleyError>(&meter)) run.error = exact->norms();
    return run;
}

/// The run with the smallest cells and, among those, the smallest steps becomes the truth.
void measure_against_finest(std::vector<StudyRun>& runs)
{
    const auto finest = std::min_element(runs.begin(), runs.end(), [](const StudyRun& a, const StudyRun& b) {
        return std::abs(a.h - b.h) > 1e-9 * b.h ? a.h < b.h : a.dt < b.dt;
    });
    finest->is_reference = true;
    for (StudyRun& run : runs) run.error = difference(run.trace, finest->trace);
}

} // namespace

std::vector<StudyRun> run_study(const StudyPlan& plan, const core::Communicator& ranks, const StudyResources& resources,
                                const std::function<void(const StudyRun&)>& told)
{
    std::vector<StudyRun> runs;
    for (const StudyCase& one : plan.cases) {
        StudyRun best = run_once(plan.study, one, ranks, resources);
        for (int n = 1; n < plan.study.repeats; ++n) {
            const StudyRun again = run_once(plan.study, one, ranks, resources);
            best.wall = std::min(best.wall, again.wall);
            best.processor = std::min(best.processor, again.processor);
        }
        told(best);
        runs.push_back(std::move(best));
    }
    if (plan.study.error == StudyError::self) measure_against_finest(runs);
    return runs;
}

} // namespace io

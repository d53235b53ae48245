// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago run: from a scene to its results.
#include "core/base/error.hpp"
#include "io/cli/command.hpp"
#include "io/cli/parallel_options.hpp"
#include "io/cli/together.hpp"
#include "io/run/simulation.hpp"
#include "io/scene/scene_reader.hpp"
#include "io/scene/units.hpp"
#include <memory>

namespace io {
namespace {

struct Arguments {
    std::string scene, output, until;
    std::vector<std::string> overrides;
    bool restart = false, force = false, trace = false;
    ParallelOptions parallel;
};

RunDirectory::Existing existing(const Arguments& a)
{
    core::require<core::ConfigError>(!(a.restart && a.force), "--restart goes on with a run, --force replaces it: choose one");
    return a.restart ? RunDirectory::Existing::resume : a.force ? RunDirectory::Existing::replace : RunDirectory::Existing::refuse;
}

/// The end that --until asks for [s].
std::optional<double> chosen_end(const std::string& until)
{
    if (until.empty()) return std::nullopt;
    const QuantityResult end = Units().read(until, "s");
    core::require<core::ConfigError>(end.error.empty(), "--until: " + end.error + (end.hint.empty() ? "" : "; " + end.hint));
    core::require<core::ConfigError>(end.value > 0, "--until: the end must lie after t = 0");
    return end.value;
}

int run(const Arguments& a, Invocation invocation)
{
    const Scene scene = read_scene(a.scene, a.overrides);
    const std::optional<double> until = chosen_end(a.until);
    if (const auto code = begin_parallel(a.parallel, invocation)) return *code;
    const core::MpiSession session(invocation.argc, invocation.argv);
    const core::Communicator ranks = core::Communicator::world();
    SimulationOptions options;
    options.directory = a.output.empty() ? default_run_directory(scene_file(a.scene)) : std::filesystem::path(a.output);
    options.existing = existing(a);
    options.executor = a.parallel.executor;
    options.threads = chosen_threads(a.parallel, ranks.size());
    options.trace = a.trace;
    options.until = until;
    options.command = {invocation.argv, invocation.argv + invocation.argc};
    return run_together(ranks, [&] {
        Simulation simulation(scene, ranks, options);
        return simulation.run() == StopReason::none ? exit_success : exit_stopped_with_checkpoint;
    });
}

} // namespace

Command run_command()
{
    auto a = std::make_shared<Arguments>(); // shared: the options and run() both need it
    std::vector<Option> options{{"scene", "A scene.yaml or its folder", &a->scene, true},
                                {"-o,--output", "Run directory; runs/<scene> by default", &a->output},
                                {"--until", "Simulated time at which to end instead of run.until, such as '0.2 s'", &a->until},
                                {"--restart", "Go on from the newest good checkpoint, on any number of ranks", &a->restart},
                                {"--force", "Replace an earlier run", &a->force},
                                {"--trace", "Write trace.json for ui.perfetto.dev and sum it up", &a->trace},
                                {"--set", "Override one key: key.path=value", &a->overrides}};
    for (const Option& option : parallel_options(a->parallel)) options.push_back(option);
    return {"run", "Run a scene", options, [a](const Invocation& invocation) { return run(*a, invocation); }};
}

} // namespace io

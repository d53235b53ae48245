// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago study: error against run time over cells, time steps and whatever else a study varies.
#include "io/cli/command.hpp"
#include "io/cli/parallel_options.hpp"
#include "io/files/rank_zero.hpp"
#include "io/run/run_directory.hpp"
#include "io/study/study_ensemble.hpp"
#include "io/study/study_report.hpp"
#include <fmt/format.h>
#include <memory>

namespace io {
namespace {

struct Arguments {
    std::string study, output;
    ParallelOptions parallel;
};

std::filesystem::path study_file(const std::filesystem::path& path)
{
    return std::filesystem::is_directory(path) ? path / "study.yaml" : path;
}

std::filesystem::path output_folder(const Arguments& a)
{
    if (!a.output.empty()) return a.output;
    const auto scene = study_file(a.study).parent_path() / "scene.yaml"; // studies and runs of one folder share its name
    return default_run_directory(scene).string() + "_study";
}

int run(const Arguments& a, Invocation invocation)
{
    const StudyPlan plan = read_study(study_file(a.study));
    if (const auto code = begin_parallel(a.parallel, invocation)) return *code;
    const core::MpiSession session(invocation.argc, invocation.argv);
    const core::Communicator ranks = core::Communicator::world();
    const StudyResources resources{a.parallel.executor, chosen_threads(a.parallel, ranks.size())};
    const auto say = [&](const std::string& text) {
        if (ranks.rank() == 0) fmt::print("{}\n", text);
    };
    say(fmt::format("{}: {} cases on {} ranks x {} threads", plan.study.name, plan.cases.size(), ranks.size(), resources.threads));
    const auto runs = run_study(plan, ranks, resources, [&](const StudyRun& one) { say(progress_text(plan, one)); });
    const StudyReport report = report_of(plan, runs, ranks);
    on_rank_zero<core::FileError>(ranks, [&] { write_report(report, output_folder(a)); });
    const bool ensemble = plan.study.error == StudyError::ensemble;
    const std::string table = ensemble ? ensemble_table(plan, ensemble_of(plan, runs)) : table_text(report);
    say(fmt::format("\n{}written to {}", table, output_folder(a).string()));
    return exit_success;
}

} // namespace

Command study_command()
{
    auto a = std::make_shared<Arguments>(); // shared: the options and run() both need it
    std::vector<Option> options{
        {"study", "A study.yaml or its folder", &a->study, true},
        {"-o,--output", "Folder of study.csv, study.json and study.svg or ensemble.csv; runs/<scene>_study by default", &a->output}};
    for (const Option& option : parallel_options(a->parallel)) options.push_back(option);
    return {"study", "Measure error against run time", options, [a](const Invocation& invocation) { return run(*a, invocation); }};
}

} // namespace io

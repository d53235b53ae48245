// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// A study measures what the scheme promises: second order in space and time, from a scene to its report.
#include "core/base/error.hpp"
#include "core/comm/communicator.hpp"
#include "io/study/study_ensemble.hpp"
#include "io/study/study_report.hpp"
#include "tests/support/source_root.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace {

std::filesystem::path study_in(const TemporaryFolder& folder, const std::string& rest)
{
    const auto file = folder.path() / "study.yaml";
    write_file(file, "name: test\nscene: " + (test::source_root() / "configs" / "pipe_womersley").string() + "\n" + rest);
    return file;
}

std::vector<io::StudyRun> runs_of(const io::StudyPlan& plan)
{
    return io::run_study(plan, core::Communicator::world(), {"serial", 1}, [](const io::StudyRun&) {});
}

} // namespace

TEST_CASE("oscillating pipe flow is second order in space and in time")
{
    const TemporaryFolder folder;
    const auto plan =
        io::read_study(study_in(folder, "error: womersley\nvary: { cells: [[12, 2], [24, 2]], steps_per_period: [10, 20, 40] }\n"));
    REQUIRE(plan.cases.size() == 6);
    const auto runs = runs_of(plan);
    const auto report = io::report_of(plan, runs, core::Communicator::world());
    MESSAGE(io::table_text(report));
    CHECK(report.orders.back().h.value_or(0) > 1.7);  // 2 in the limit; coarse cells at the wall cost a little
    CHECK(report.orders.back().dt.value_or(0) > 1.9); // differences between steps on one grid are free of the error of space
    CHECK(runs.back().error.e_2 < 0.01);
    io::write_report(report, folder.path() / "out");
    for (const char* name : {"study.csv", "study.json", "study.svg"}) CHECK(std::filesystem::file_size(folder.path() / "out" / name) > 500);
}

TEST_CASE("without an exact solution the finest case is the reference, and errors fall towards it")
{
    const TemporaryFolder folder;
    const auto plan =
        io::read_study(study_in(folder, "error: self\nvary:\n  cells: [[8, 2]]\n  knobs:\n    - { name: until, set: [run.until=0.5 s] }\n"
                                        "    - { name: dt, set: [run.time_step=50 ms, run.time_step=25 ms, run.time_step=12.5 ms] }\n"));
    const auto runs = runs_of(plan);
    REQUIRE(runs.size() == 3);
    CHECK(runs[2].is_reference);
    CHECK(runs[1].error.e_2 < 0.5 * runs[0].error.e_2); // (1/2)^2 - (1/4)^2 over 1 - (1/4)^2 is a fifth at second order
    CHECK(runs[1].error.e_2 > 0);
}

TEST_CASE("the interval of an ensemble is Student's")
{
    const io::Estimate estimate = io::estimate_of({1.0, 2.0, 3.0});
    CHECK(estimate.mean == 2.0);
    CHECK(std::abs(estimate.half_width - 4.303 / std::sqrt(3.0)) < 1e-3); // t of two degrees of freedom times s / sqrt n
    // Forty values of two kinds: s^2 = 40 / 39, t = 2.0227.
    std::vector<double> many(40, 1.0);
    for (std::size_t n = 0; n < 20; ++n) many[n] = -1.0;
    CHECK(std::abs(io::estimate_of(many).half_width - 2.0227 / std::sqrt(39.0)) < 2e-4);
}

TEST_CASE("an ensemble runs seeds that differ, and says mean and interval of what a run ends with")
{
    const TemporaryFolder folder;
    write_file(folder.path() / "scene.yaml",
               "name: few\ngrid: { box: { size: [10 mm, 20 mm, 10 mm], cells: [4, 8, 4] } }\ngravity: { direction: -y }\n"
               "particles: [{ name: glass, count: 20, diameter: 1 mm, density: 2500 kg/m3 }]\n"
               "contact: { law: linear, stiffness: 1 kN/m, walls: primitive }\nrun: { until: 5 ms }\n");
    const auto file = folder.path() / "study.yaml";
    write_file(file, "name: test\nscene: scene.yaml\nerror: ensemble\nvary: { seeds: 4 }\n");
    const auto plan = io::read_study(file);
    REQUIRE(plan.cases.size() == 4);
    const auto runs = runs_of(plan);
    const auto rows = io::ensemble_of(plan, runs);
    const auto row = std::find_if(rows.begin(), rows.end(), [](const auto& r) { return r.metric == "mean_height_glass"; });
    REQUIRE(row != rows.end());
    CHECK(row->runs == 4);
    // They fall freely by g t^2 / 2, whatever the seed, as long as none meets the floor or another: to a few bounces.
    CHECK(row->change.mean < -0.5 * 0.5 * 9.81 * 25e-6);
    CHECK(row->at_the_end.half_width > 0); // the seeds differ
    CHECK(row->at_the_end.half_width < 5e-3);
    io::write_report(io::report_of(plan, runs, core::Communicator::world()), folder.path() / "out");
    CHECK(std::filesystem::file_size(folder.path() / "out" / "ensemble.csv") > 200);
    write_file(file, "name: test\nscene: scene.yaml\nerror: self\nvary: { seeds: 4 }\n");
    CHECK_THROWS_AS((void)io::read_study(file), core::ConfigError);
}

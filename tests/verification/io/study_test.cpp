// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// A study measures what the scheme promises: second order in space and time, from a scene to its report.
#include "core/comm/communicator.hpp"
#include "io/study_report.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <doctest/doctest.h>

namespace {

const std::filesystem::path source_root = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();

std::filesystem::path study_in(const TemporaryFolder& folder, const std::string& rest)
{
    const auto file = folder.path() / "study.yaml";
    write_file(file, "name: test\nscene: " + (source_root / "configs" / "pipe_womersley").string() + "\n" + rest);
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

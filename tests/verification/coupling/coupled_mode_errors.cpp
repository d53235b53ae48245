// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The study of configs/coupling_modes: all coupling modes converge in space, and to the same answer (NUMERICS C5.7).
#include "core/comm/communicator.hpp"
#include "io/study/study_report.hpp"
#include "tests/support/source_root.hpp"
#include <doctest/doctest.h>
#include <map>

TEST_CASE("in all coupling modes sinking sand in a swinging flow converges with the time step, to one answer")
{
    const auto plan = io::read_study(test::source_root() / "configs" / "coupling_modes" / "study.yaml");
    const auto ranks = core::Communicator::world();
    const auto runs = io::run_study(plan, ranks, {"serial", 1}, [](const io::StudyRun&) {});
    MESSAGE(io::table_text(io::report_of(plan, runs, ranks)));
    std::map<std::string, std::vector<const io::StudyRun*>> modes; // from the longest step to the shortest
    for (const io::StudyRun& run : runs) modes[run.labels.back()].push_back(&run);
    REQUIRE(modes.size() == 4);
    for (const auto& [mode, of] : modes) {
        INFO(mode);
        for (const io::StudyRun* run : of) CHECK(run->warnings.empty()); // no mode was replaced by a safer one
        // From 3 ms to 0.5 ms first order is a factor of 6, second order one of 36; 24 to 31 measured.
        CHECK(of[3]->error.e_2 < of[0]->error.e_2 / 16);
        // At 0.1 ms modes differ by no more than what is left of the errors of both, a fifth of those at 0.5 ms: they come to one answer.
        CHECK(of[4]->error.e_2 < 0.2 * (of[3]->error.e_2 + modes.at("pipelined")[3]->error.e_2));
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A study as a table for people, as CSV and JSON for programs, and as a picture of error against run time.
#include "io/study/study_orders.hpp"

namespace io {

struct StudyReport {
    const StudyPlan& plan;
    const std::vector<StudyRun>& runs;
    std::vector<ObservedOrders> orders;
    std::vector<bool> front;
};

/// Collective.
[[nodiscard]] StudyReport report_of(const StudyPlan& plan, const std::vector<StudyRun>& runs, const core::Communicator& ranks);

/// One line for a run while the study goes on.
[[nodiscard]] std::string progress_text(const StudyPlan& plan, const StudyRun& run);
/// Runs, errors, orders and cost; a star marks the front.
[[nodiscard]] std::string table_text(const StudyReport& report);
[[nodiscard]] std::string csv_text(const StudyReport& report);
/// An array with one object for each run, each on a line of its own (NUMERICS F).
[[nodiscard]] std::string json_text(const StudyReport& report);
/// Error against core-seconds, one curve for each choice of everything but the cells, and the front; SVG.
[[nodiscard]] std::string plot_text(const StudyReport& report);

/// study.csv, study.json, and study.svg or, of ensembles, ensemble.csv. @throws core::FileError
void write_report(const StudyReport& report, const std::filesystem::path& folder);

} // namespace io

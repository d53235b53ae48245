// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs that differ in their seed alone: mean and 95 % confidence interval of every metric.
#include "io/study/study_run.hpp"

namespace io {

/// Mean of a sample and half of its 95 % confidence interval, by Student's distribution.
struct Estimate {
    double mean = 0.0, half_width = 0.0;
};
/// @pre two values or more
[[nodiscard]] Estimate estimate_of(const std::vector<double>& values);

/// A metric of one case over all seeds.
struct EnsembleRow {
    std::vector<std::string> labels; ///< of the case, without the seed
    std::string metric;
    int runs = 0;
    Estimate at_the_end, change; ///< and since the start
};

/// Case by case, metric by metric. @pre plan.study.error is ensemble
[[nodiscard]] std::vector<EnsembleRow> ensemble_of(const StudyPlan& plan, const std::vector<StudyRun>& runs);

[[nodiscard]] std::string ensemble_csv(const StudyPlan& plan, const std::vector<EnsembleRow>& rows);
/// For people: what changes at all.
[[nodiscard]] std::string ensemble_table(const StudyPlan& plan, const std::vector<EnsembleRow>& rows);

} // namespace io

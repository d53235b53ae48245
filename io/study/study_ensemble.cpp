// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/study_ensemble.hpp"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace io {
namespace {

/// The factor that 95 % of Student's t with this many degrees of freedom stay below, both signs; beyond the table to 0.1 %.
double student(int freedom)
{
    constexpr std::array table{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131};
    if (freedom <= int(table.size())) return table[std::size_t(freedom - 1)];
    return 1.96 + 2.372 / freedom + 2.82 / (double(freedom) * freedom);
}

std::vector<std::string> without_seed(const StudyPlan& plan, const std::vector<std::string>& labels)
{
    std::vector<std::string> kept;
    for (std::size_t a = 0; a < labels.size(); ++a)
        if (plan.axes[a] != seed_axis) kept.push_back(labels[a]);
    return kept;
}

std::string label_text(const std::vector<std::string>& labels, const char* form)
{
    std::string text;
    for (const std::string& label : labels) text += fmt::format(fmt::runtime(form), label);
    return text;
}

} // namespace

Estimate estimate_of(const std::vector<double>& values)
{
    const auto n = double(values.size());
    double sum = 0, squares = 0;
    for (const double x : values) sum += x;
    const double mean = sum / n;
    for (const double x : values) squares += (x - mean) * (x - mean);
    return {mean, student(int(n) - 1) * std::sqrt(squares / (n - 1) / n)};
}

std::vector<EnsembleRow> ensemble_of(const StudyPlan& plan, const std::vector<StudyRun>& runs)
{
    std::map<std::vector<std::string>, std::vector<const StudyRun*>> cases;
    std::vector<std::vector<std::string>> order; // of first appearance
    for (const StudyRun& run : runs) {
        auto& members = cases[without_seed(plan, run.labels)];
        if (members.empty()) order.push_back(without_seed(plan, run.labels));
        members.push_back(&run);
    }
    std::vector<EnsembleRow> rows;
    for (const auto& labels : order) {
        const auto& members = cases[labels];
        for (std::size_t m = 0; m < members.front()->metrics.size(); ++m) {
            std::vector<double> last, change;
            for (const StudyRun* run : members) {
                last.push_back(run->at_the_end[m]);
                change.push_back(run->at_the_end[m] - run->at_start[m]);
            }
            rows.push_back({labels, members.front()->metrics[m], int(members.size()), estimate_of(last), estimate_of(change)});
        }
    }
    return rows;
}

std::string ensemble_csv(const StudyPlan& plan, const std::vector<EnsembleRow>& rows)
{
    std::string text;
    for (const std::string& axis : without_seed(plan, plan.axes)) text += axis + ",";
    text += "metric,runs,mean,half_width_95,mean_change,half_width_95_of_change\n";
    for (const EnsembleRow& row : rows)
        text += fmt::format("{}{},{},{:.9g},{:.3g},{:.9g},{:.3g}\n", label_text(row.labels, "{},"), row.metric, row.runs,
                            row.at_the_end.mean, row.at_the_end.half_width, row.change.mean, row.change.half_width);
    return text;
}

std::string ensemble_table(const StudyPlan& plan, const std::vector<EnsembleRow>& rows)
{
    std::string text = label_text(without_seed(plan, plan.axes), "{:>14} ");
    text += fmt::format("{:>28} {:>5} {:>13} {:>10} {:>13} {:>10}\n", "metric", "runs", "mean", "+- 95 %", "change", "+- 95 %");
    for (const EnsembleRow& row : rows) {
        if (row.change.mean == 0 && row.change.half_width == 0) continue;
        text += fmt::format("{}{:>28} {:>5} {:>13.6g} {:>10.2g} {:>13.6g} {:>10.2g}\n", label_text(row.labels, "{:>14} "), row.metric,
                            row.runs, row.at_the_end.mean, row.at_the_end.half_width, row.change.mean, row.change.half_width);
    }
    return text;
}

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/study_report.hpp"
#include "core/base/error.hpp"
#include "io/run/manifest.hpp"
#include "io/run/version.hpp"
#include "io/study/log_plot.hpp"
#include "io/study/study_ensemble.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace io {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between)
{
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
    return all;
}

std::string number(const std::optional<double>& value, const char* form = "{:.2f}")
{
    return value ? fmt::format(fmt::runtime(form), *value) : std::string();
}

std::optional<double> known(const StudyRun& run, double error)
{
    return run.is_reference || !run.metrics.empty() ? std::optional<double>() : error;
}

nlohmann::ordered_json or_null(const std::optional<double>& value)
{
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// Of the error that is not known, nothing is shown.
nlohmann::ordered_json object_of(const StudyReport& report, std::size_t n, const nlohmann::ordered_json& machine)
{
    const StudyRun& run = report.runs[n];
    nlohmann::ordered_json choices;
    for (std::size_t a = 0; a < run.labels.size(); ++a) choices[report.plan.axes[a]] = run.labels[a];
    return {{"case", report.plan.study.name},
            {"choices", choices},
            {"git", git_commit()},
            {"machine", machine},
            {"ranks", run.ranks},
            {"threads", run.threads},
            {"h", run.h},
            {"dt", run.dt},
            {"tolerance", run.tolerance},
            {"cells", run.cells},
            {"particles", run.particles},
            {"steps", run.steps},
            {"e_2", or_null(known(run, run.error.e_2))},
            {"e_inf", or_null(known(run, run.error.e_inf))},
            {"order_h", or_null(report.orders[n].h)},
            {"order_dt", or_null(report.orders[n].dt)},
            {"wall_seconds", run.wall},
            {"core_seconds", run.core_seconds()},
            {"processor_seconds", run.processor},
            {"cell_steps_per_second", run.cell_steps_per_second()},
            {"pressure_iterations", run.iterations},
            {"on_front", bool(report.front[n])}};
}

void write_text(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream stream(file);
    stream << text;
    core::require<core::FileError>(stream.good(), file.string() + " cannot be written");
}

/// Points in the order of their cost.
Curve curve_of(const std::string& name, std::vector<const StudyRun*> runs)
{
    std::sort(runs.begin(), runs.end(), [](const auto* a, const auto* b) { return a->core_seconds() < b->core_seconds(); });
    Curve curve{name, {}, {}};
    for (const StudyRun* run : runs) {
        curve.x.push_back(run->core_seconds());
        curve.y.push_back(run->error.e_2);
    }
    return curve;
}

/// The labels of all axes but the first, which a curve runs along.
std::string curve_name(const StudyReport& report, const StudyRun& run)
{
    std::vector<std::string> words;
    for (std::size_t a = 1; a < run.labels.size(); ++a) words.push_back(report.plan.axes[a] + " " + run.labels[a]);
    return words.empty() ? report.plan.axes.front() : joined(words, ", ");
}

} // namespace

StudyReport report_of(const StudyPlan& plan, const std::vector<StudyRun>& runs, const core::Communicator& ranks)
{
    if (plan.study.error == StudyError::ensemble)
        return {plan, runs, std::vector<ObservedOrders>(runs.size()), std::vector<bool>(runs.size())};
    return {plan, runs, observed_orders(runs, ranks), pareto_front(runs)};
}

std::string progress_text(const StudyPlan& plan, const StudyRun& run)
{
    std::vector<std::string> words;
    for (std::size_t a = 0; a < run.labels.size(); ++a) words.push_back(plan.axes[a] + " " + run.labels[a]);
    const std::string error = plan.study.error != StudyError::womersley ? "" : fmt::format(": e_2 = {:.3e}", run.error.e_2);
    std::string text = fmt::format("{}{}, {} steps in {:.2f} s", joined(words, ", "), error, run.steps, run.wall);
    for (const std::string& warning : run.warnings) text += "\n  " + warning;
    return text;
}

std::string table_text(const StudyReport& report)
{
    std::string text;
    for (const std::string& axis : report.plan.axes) text += fmt::format("{:>10} ", axis);
    text += fmt::format("{:>9} {:>9} {:>10} {:>10} {:>7} {:>8} {:>9} {:>9} {:>12} {:>10}\n", "h [mm]", "dt [ms]", "e_2", "e_inf", "order h",
                        "order dt", "core-s", "cpu [s]", "cell-steps/s", "iterations");
    for (std::size_t n = 0; n < report.runs.size(); ++n) {
        const StudyRun& run = report.runs[n];
        for (const std::string& label : run.labels) text += fmt::format("{:>10} ", label);
        const std::string e_2 = run.is_reference ? "reference" : fmt::format("{:.3e}", run.error.e_2);
        text +=
            fmt::format("{:>9.4g} {:>9.4g} {:>10} {:>10} {:>7} {:>8} {:>9.3f} {:>9.3f} {:>12.3g} {:>10.1f}{}\n", 1e3 * run.h, 1e3 * run.dt,
                        e_2, number(known(run, run.error.e_inf), "{:.3e}"), number(report.orders[n].h), number(report.orders[n].dt),
                        run.core_seconds(), run.processor, run.cell_steps_per_second(), run.iterations, report.front[n] ? " *" : "");
    }
    return text + "* no other run has both a smaller error and fewer core-seconds\n";
}

std::string csv_text(const StudyReport& report)
{
    std::string text = joined(report.plan.axes, ",") +
                       ",ranks,threads,h,dt,tolerance,cells,particles,steps,e_2,e_inf,order_h,order_dt,wall_seconds,"
                       "core_seconds,processor_seconds,cell_steps_per_second,pressure_iterations,on_front\n";
    for (std::size_t n = 0; n < report.runs.size(); ++n) {
        const StudyRun& run = report.runs[n];
        for (const std::string& label : run.labels)
            text += label.find_first_of(",\"") == std::string::npos ? label + "," : "\"" + label + "\",";
        text += fmt::format("{},{},{},{},{},{},{},{},", run.ranks, run.threads, run.h, run.dt, run.tolerance, run.cells, run.particles,
                            run.steps);
        for (const auto& value : {known(run, run.error.e_2), known(run, run.error.e_inf), report.orders[n].h, report.orders[n].dt})
            text += number(value, "{:.6g}") + ",";
        text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{}\n", run.wall, run.core_seconds(), run.processor,
                            run.cell_steps_per_second(), run.iterations, int(report.front[n]));
    }
    return text;
}

std::string json_text(const StudyReport& report)
{
    const StudyRun& first = report.runs.front();
    const auto machine = nlohmann::ordered_json::parse(manifest_text({{}, first.ranks, first.threads, ""}))["machine"];
    std::string lines;
    for (std::size_t n = 0; n < report.runs.size(); ++n) lines += (lines.empty() ? "" : ",\n") + object_of(report, n, machine).dump();
    return "[\n" + lines + "\n]\n";
}

std::string plot_text(const StudyReport& report)
{
    std::map<std::string, std::vector<const StudyRun*>> groups;
    std::vector<const StudyRun*> front;
    std::vector<std::string> order; // of first appearance
    for (std::size_t n = 0; n < report.runs.size(); ++n) {
        const StudyRun& run = report.runs[n];
        if (run.is_reference) continue;
        const std::string name = curve_name(report, run);
        if (!groups.contains(name)) order.push_back(name);
        groups[name].push_back(&run);
        if (report.front[n]) front.push_back(&run);
    }
    LogPlot plot{report.plan.study.name, "core-seconds", "relative error e_2", {}, {}};
    for (const std::string& name : order) plot.curves.push_back(curve_of(name, groups[name]));
    plot.curves.push_back(curve_of("front", front));
    return to_svg(plot);
}

void write_report(const StudyReport& report, const std::filesystem::path& folder)
{
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    core::require<core::FileError>(!failure, folder.string() + " cannot be made: " + failure.message());
    write_text(folder / "study.csv", csv_text(report));
    write_text(folder / "study.json", json_text(report));
    if (report.plan.study.error == StudyError::ensemble)
        write_text(folder / "ensemble.csv", ensemble_csv(report.plan, ensemble_of(report.plan, report.runs)));
    else write_text(folder / "study.svg", plot_text(report));
}

} // namespace io

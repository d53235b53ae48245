// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/report.hpp"
#include "core/base/error.hpp"
#include "io/run/metrics.hpp"
#include "io/study/line_plot.hpp"
#include "io/study/svg.hpp"
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace io {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t most_frames = 12;

constexpr const char* style = R"(body{font:15px/1.5 system-ui,sans-serif;color:#1d2733;background:#f6f7f9;margin:0}
main{max-width:1180px;margin:0 auto;padding:32px 24px}h1{font-size:26px;margin:0 0 4px}h2{font-size:18px;margin:36px 0 12px}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(480px,1fr));gap:16px}
.grid>*{background:#fff;border:1px solid #e0e4e9;border-radius:8px;width:100%;height:auto;box-sizing:border-box}
figure{margin:0;overflow:hidden}figure img{width:100%;display:block}figcaption{padding:4px 10px;color:#5b6672;font-size:13px}
pre{background:#fff;border:1px solid #e0e4e9;border-radius:8px;padding:14px;overflow:auto;font-size:13px}
table{border-collapse:collapse}td{padding:2px 18px 2px 0;vertical-align:top}td:first-child{color:#5b6672})";

std::string contents(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string base64(const std::string& bytes)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (n + k < bytes.size() ? static_cast<unsigned char>(bytes[n + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += n + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

std::string facts(const RunDirectory& run)
{
    const auto manifest = nlohmann::json::parse(contents(run.manifest()), nullptr, false);
    if (!manifest.is_object()) return "";
    std::string rows;
    for (const auto& [key, value] : manifest.items()) {
        const std::string words = value.is_string() ? value.get<std::string>() : value.dump();
        rows += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", svg::escaped(key), svg::escaped(words));
    }
    return "<h2>Run</h2>\n<table>\n" + rows + "</table>\n";
}

/// How fluid and particles were coupled, and of traced runs what the two lanes did at the same time: as the log says it.
std::string lanes(const RunDirectory& run)
{
    std::istringstream log(contents(run.log()));
    std::string lines;
    for (std::string line; std::getline(log, line);)
        if (line.find("] coupling") != std::string::npos || line.find("lanes overlap") != std::string::npos)
            lines += svg::escaped(line) + "\n";
    return lines.empty() ? lines : "<h2>Coupling and lanes</h2>\n<pre>" + lines + "</pre>\n";
}

/// Columns that differ by the axis or the species alone share a plot.
std::string plot_of(const std::string& column)
{
    for (const std::string axis : {"_x", "_y", "_z"})
        if (column.ends_with(axis)) return column.substr(0, column.size() - axis.size());
    for (const std::string group : {"mean_height_error_", "mean_height_"})
        if (column.starts_with(group)) return group.substr(0, group.size() - 1);
    return column;
}

std::string curves(const RunDirectory& run)
{
    if (!fs::exists(run.metrics())) return "";
    const MetricsTable table = read_metrics(run.metrics());
    const auto column = [&](std::size_t c) {
        std::vector<double> values;
        for (const auto& row : table.rows) values.push_back(row[c]);
        return values;
    };
    std::vector<LinePlot> plots;
    for (std::size_t c = 1; c < table.columns.size(); ++c) {
        const std::string name = plot_of(table.columns[c]);
        if (name == "step" || name == "mean_height_error") continue;
        auto plot = std::find_if(plots.begin(), plots.end(), [&](const LinePlot& p) { return p.y_label == name; });
        if (plot == plots.end()) plot = plots.insert(plot, {"", "time [s]", name, {}});
        const std::string rest = table.columns[c].size() > name.size() ? table.columns[c].substr(name.size() + 1) : name;
        plot->curves.push_back({rest, column(0), column(c)});
    }
    std::string out;
    for (LinePlot& plot : plots) {
        plot.title = plot.y_label;
        std::replace(plot.title.begin(), plot.title.end(), '_', ' ');
        plot.y_label.clear();
        out += to_svg(plot);
    }
    return out.empty() ? out : "<h2>Curves</h2>\n<div class=\"grid\">\n" + out + "</div>\n";
}

std::string frames(const RunDirectory& run)
{
    std::vector<fs::path> all;
    std::error_code none; // a run without pictures has no such folder
    for (const auto& entry : fs::directory_iterator(run.frames(), none))
        if (entry.path().extension() == ".png") all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    std::string out;
    const std::size_t shown = std::min(all.size(), most_frames);
    for (std::size_t n = 0; n < shown; ++n) {
        const fs::path& path = all[shown > 1 ? n * (all.size() - 1) / (shown - 1) : 0];
        out += fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
                           svg::escaped(path.stem().string()), base64(contents(path)));
    }
    return out.empty() ? out : "<h2>Pictures</h2>\n<div class=\"grid\">\n" + out + "</div>\n";
}

} // namespace

std::string report_html(const RunDirectory& run)
{
    if (!fs::exists(run.manifest())) throw core::ConfigError(run.root().string() + " has no run: manifest.json is missing");
    const fs::path whole = fs::absolute(run.root()).lexically_normal();
    const std::string name = svg::escaped((whole.has_filename() ? whole : whole.parent_path()).filename().string());
    const std::string scene = contents(run.scene());
    return fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n<style>{1}</style></head>\n"
                       "<body><main>\n<h1>{0}</h1>\n",
                       name, style) +
           frames(run) + curves(run) + lanes(run) + (scene.empty() ? "" : "<h2>Scene</h2>\n<pre>" + svg::escaped(scene) + "</pre>\n") +
           facts(run) + "</main></body></html>\n";
}

} // namespace io

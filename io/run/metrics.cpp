// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/metrics.hpp"

#include "core/base/error.hpp"
#include "io/files/durable.hpp"
#include "io/scene/units.hpp"
#include <fmt/format.h>
#include <iterator>
#include <limits>

namespace io {

namespace {

[[nodiscard]] std::vector<std::string> cells_of_line(const std::string& line)
{
    std::vector<std::string> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        cells.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return cells;
}

[[nodiscard]] std::string line_of(std::span<const double> row)
{
    std::string line;
    for (double x : row) line += (line.empty() ? "" : ",") + number_text(x);
    return line + "\n";
}

[[nodiscard]] std::string header_of(const std::vector<std::string>& columns) { return fmt::format("{}\n", fmt::join(columns, ",")); }

/// The whole text of the rows up to a time.
[[nodiscard]] std::string kept_text(const MetricsTable& table, double restart_time)
{
    std::string text = header_of(table.columns);
    for (const auto& row : table.rows)
        if (row.front() <= restart_time) text += line_of(row);
    return text;
}

[[nodiscard]] double number_of(const std::string& cell, const std::filesystem::path& file)
{
    if (cell == "nan" || cell == "-nan") return std::numeric_limits<double>::quiet_NaN();
    if (cell == "inf" || cell == "-inf") return (cell.front() == '-' ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
    const auto number = parse_number(cell);
    core::require<core::FileError>(number.has_value(), fmt::format("{}: '{}' is not a number", file.string(), cell));
    return *number;
}

} // namespace

MetricsTable read_metrics(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    core::require<core::FileError>(stream.good(), fmt::format("{} cannot be read", file.string()));
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    text.resize(text.rfind('\n') + 1); // npos + 1 is 0
    MetricsTable table;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        const auto cells = cells_of_line(text.substr(begin, end - begin));
        begin = end + 1;
        if (table.columns.empty()) {
            table.columns = cells;
            continue;
        }
        core::require<core::FileError>(cells.size() == table.columns.size(),
                                       fmt::format("{}: row {} has {} values for {} columns", file.string(), table.rows.size() + 1,
                                                   cells.size(), table.columns.size()));
        auto& row = table.rows.emplace_back();
        for (const auto& cell : cells) row.push_back(number_of(cell, file));
    }
    return table;
}

MetricsWriter::MetricsWriter(const std::filesystem::path& file, std::vector<std::string> columns, std::optional<double> restart_time)
    : path_(file), columns_(std::move(columns))
{
    if (restart_time && std::filesystem::exists(file)) {
        const MetricsTable table = read_metrics(file);
        core::require<core::FileError>(table.columns == columns_, fmt::format("{} has other columns than this run", file.string()));
        write_durably(file.string(), kept_text(table, *restart_time));
    } else {
        write_durably(file.string(), header_of(columns_));
    }
    file_.open(file, std::ios::app);
    core::require<core::FileError>(file_.good(), fmt::format("{} cannot be written", file.string()));
}

void MetricsWriter::add(std::span<const double> row)
{
    core::require<core::Error>(row.size() == columns_.size(), "a row of metrics has another length than its columns");
    file_ << line_of(row);
}

void MetricsWriter::flush()
{
    file_.flush();
    core::require<core::FileError>(file_.good(), fmt::format("{} cannot be written", path_.string()));
}

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// metrics.csv: named columns, a row for each report, the same file with and without a restart in the middle.
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace io {

/// A whole table; the first column is the time.
struct MetricsTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
};

/// @throws core::FileError if the file cannot be read or a row does not fit the columns. A last row without its line end
///         was cut off and is left out.
[[nodiscard]] MetricsTable read_metrics(const std::filesystem::path& file);

class MetricsWriter {
public:
    /// Begins a table, or goes on with one: rows later than `restart_time` are removed first.
    /// @param columns  The first one is the time [s].
    /// @throws core::FileError if the file cannot be written, or has other columns.
    MetricsWriter(const std::filesystem::path& file, std::vector<std::string> columns, std::optional<double> restart_time = {});

    /// Adds a row, one value for each column; numbers read back as the same bits.
    void add(std::span<const double> row);
    /// Hands the rows to the system; to be called with every checkpoint.
    void flush();

private:
    std::filesystem::path path_;
    std::vector<std::string> columns_;
    std::ofstream file_;
};

} // namespace io

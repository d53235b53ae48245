// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers in columns from a text file.
#include <filesystem>
#include <vector>

namespace io {

/// One row of numbers for each line, separated by commas, semicolons or blanks; blank lines, lines that begin with # and a first line of
/// words are passed over.
/// @throws core::ConfigError with file and line if the file cannot be read, or a line has not `columns` numbers.
[[nodiscard]] std::vector<std::vector<double>> read_table_file(const std::filesystem::path& file, std::size_t columns);

} // namespace io

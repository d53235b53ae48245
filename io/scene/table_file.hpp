// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers and words in columns from a text file.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace io {

struct Word {
    std::string text;
    int column = 0; ///< Where it begins in its line, from 1.
};

/// Calls visit(number of the line, the line, its words) for each line, words separated by commas, semicolons or blanks; blank lines and
/// lines that begin with # are passed over.
/// @throws core::ConfigError if the file cannot be read.
void for_each_line(const std::filesystem::path& file, const std::function<void(int, const std::string&, std::vector<Word>)>& visit);

/// Is the word a finite number? If so, `value` is set.
[[nodiscard]] bool is_number(const std::string& word, double& value);

/// One row of numbers for each line; a first line of words is passed over.
/// @throws core::ConfigError with file and line if the file cannot be read, or a line has not `columns` numbers.
[[nodiscard]] std::vector<std::vector<double>> read_table_file(const std::filesystem::path& file, std::size_t columns);

} // namespace io

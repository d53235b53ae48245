// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/table_file.hpp"
#include "core/base/error.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace io {
namespace {

/// The words of a line, whatever separates them.
std::vector<std::string> words_of(std::string line)
{
    for (char& c : line)
        if (c == ',' || c == ';' || c == '\t' || c == '\r') c = ' ';
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

bool is_number(const std::string& word, double& value)
{
    const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

} // namespace

std::vector<std::vector<double>> read_table_file(const std::filesystem::path& file, std::size_t columns)
{
    std::ifstream stream(file);
    core::require<core::ConfigError>(stream.good(), fmt::format("{} cannot be read", file.string()));
    std::vector<std::vector<double>> rows;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        const std::vector<std::string> words = words_of(line);
        if (words.empty() || words.front().starts_with('#')) continue;
        std::vector<double> row(words.size());
        const auto read = [&](std::size_t n) { return is_number(words[n], row[n]); };
        bool good = words.size() == columns;
        for (std::size_t n = 0; n < words.size(); ++n) good = read(n) && good;
        double unused = 0;
        if (!good && rows.empty() && number == 1 && !is_number(words.front(), unused)) continue; // names of the columns
        core::require<core::ConfigError>(good, fmt::format("{}:{}: {} numbers are needed, not '{}'", file.string(), number, columns, line));
        rows.push_back(std::move(row));
    }
    core::require<core::ConfigError>(!rows.empty(), fmt::format("{} has no numbers", file.string()));
    return rows;
}

} // namespace io

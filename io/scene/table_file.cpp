// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/table_file.hpp"
#include "core/base/error.hpp"
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace io {

namespace {

constexpr const char* separators = ",; \t\r";

std::vector<Word> words_of(const std::string& line)
{
    std::vector<Word> words;
    for (std::size_t begin = line.find_first_not_of(separators); begin != std::string::npos;) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        words.push_back({line.substr(begin, end - begin), int(begin) + 1});
        begin = line.find_first_not_of(separators, end);
    }
    return words;
}

} // namespace

void for_each_line(const std::filesystem::path& file, const std::function<void(int, const std::string&, std::vector<Word>)>& visit)
{
    std::ifstream stream(file);
    core::require<core::ConfigError>(stream.good(), fmt::format("{} cannot be read", file.string()));
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        std::vector<Word> words = words_of(line);
        if (!words.empty() && !words.front().text.starts_with('#')) visit(number, line, std::move(words));
    }
}

bool is_number(const std::string& word, double& value)
{
    const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

std::vector<std::vector<double>> read_table_file(const std::filesystem::path& file, std::size_t columns)
{
    std::vector<std::vector<double>> rows;
    for_each_line(file, [&](int number, const std::string& line, const std::vector<Word>& words) {
        std::vector<double> row(words.size());
        bool good = words.size() == columns;
        for (std::size_t n = 0; n < words.size(); ++n) good = is_number(words[n].text, row[n]) && good;
        double unused = 0;
        if (!good && rows.empty() && number == 1 && !is_number(words.front().text, unused)) return; // names of the columns
        core::require<core::ConfigError>(good, fmt::format("{}:{}: {} numbers are needed, not '{}'", file.string(), number, columns, line));
        rows.push_back(std::move(row));
    });
    core::require<core::ConfigError>(!rows.empty(), fmt::format("{} has no numbers", file.string()));
    return rows;
}

} // namespace io

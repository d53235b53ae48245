// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/problems.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace io {

namespace {

[[nodiscard]] bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

[[nodiscard]] std::string line_of(const Source& source, int line)
{
    std::istringstream stream(source.text);
    std::string text;
    for (int n = 0; n < line; ++n)
        if (!std::getline(stream, text)) return "";
    if (!text.empty() && text.back() == '\r') text.pop_back();
    return text;
}

/// Blanks up to the column, tabs kept so that the caret stands below the place.
[[nodiscard]] std::string caret_below(const std::string& line, int column)
{
    std::string blanks;
    int character = 0;
    for (char c : line) {
        if (starts_character(c) && ++character >= column) break;
        if (starts_character(c)) blanks += c == '\t' ? '\t' : ' ';
    }
    return blanks + "^";
}

[[nodiscard]] std::string join(const std::vector<std::string>& words)
{
    std::string all;
    for (const auto& word : words) all += (all.empty() ? "" : ", ") + word;
    return all;
}

} // namespace

const Source& Problems::add_source(std::string name, std::string text)
{
    return sources_.emplace_back(Source{std::move(name), std::move(text)});
}

void Problems::add(Mark mark, std::string message, std::string hint) { problems_.push_back({mark, std::move(message), std::move(hint)}); }

std::vector<Problem> Problems::sorted() const
{
    auto rank = [&](const Source* source) {
        return std::find_if(sources_.begin(), sources_.end(), [&](const Source& s) { return &s == source; }) - sources_.begin();
    };
    auto all = problems_;
    std::stable_sort(all.begin(), all.end(), [&](const Problem& a, const Problem& b) {
        return std::tuple(rank(a.mark.source), a.mark.line, a.mark.column) < std::tuple(rank(b.mark.source), b.mark.line, b.mark.column);
    });
    return all;
}

std::string Problems::text() const
{
    std::string all;
    for (const auto& [mark, message, hint] : sorted()) {
        if (mark.source == nullptr) {
            all += fmt::format("error: {}\n", message);
        } else {
            const std::string line = line_of(*mark.source, mark.line);
            all += fmt::format("{}:{}:{}: error: {}\n", mark.source->name, mark.line, mark.column, message);
            all += fmt::format("{:>5} | {}\n      | {}\n", mark.line, line, caret_below(line, mark.column));
        }
        if (!hint.empty()) all += fmt::format("      = {}\n", hint);
    }
    return all;
}

int edit_distance(const std::string& a, const std::string& b)
{
    const std::size_t width = b.size() + 1;
    std::vector<int> d((a.size() + 1) * width);
    auto at = [&](std::size_t i, std::size_t j) -> int& { return d[i * width + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = a[i - 1] == b[j - 1] ? 0 : 1;
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    return at(a.size(), b.size());
}

std::string nearest(const std::string& word, const std::vector<std::string>& candidates)
{
    const int allowed = std::max(1, static_cast<int>(word.size()) / 3);
    std::string best;
    int best_distance = allowed + 1;
    for (const auto& candidate : candidates) {
        const int distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& candidates)
{
    const std::string best = nearest(word, candidates);
    if (!best.empty()) return fmt::format("did you mean '{}'?", best);
    return candidates.empty() ? "" : "choose from: " + join(candidates);
}

} // namespace io

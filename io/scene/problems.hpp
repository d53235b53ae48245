// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is wrong with an input text, and where: all problems are gathered and shown together.
#include <deque>
#include <string>
#include <vector>

namespace io {

/// A text that came from the user: a file, or an override of the command line.
struct Source {
    std::string name;
    std::string text;
};

/// A place in a source; line and column count from 1, columns in characters (UTF-8 code points).
struct Mark {
    const Source* source = nullptr;
    int line = 0, column = 0;
};

struct Problem {
    Mark mark;
    std::string message;
    std::string hint; ///< What to do; may be empty.
};

/// All problems found so far, and the texts they are in.
class Problems {
public:
    /// The returned reference lives as long as this object.
    const Source& add_source(std::string name, std::string text);
    void add(Mark mark, std::string message, std::string hint = "");

    [[nodiscard]] bool empty() const { return problems_.empty(); }
    [[nodiscard]] std::size_t size() const { return problems_.size(); }
    /// In the order of the text.
    [[nodiscard]] std::vector<Problem> sorted() const;
    /// For each problem: file:line:column: message, the line with a caret below the place, and the hint.
    [[nodiscard]] std::string text() const;

private:
    std::deque<Source> sources_; // a deque never moves what marks point to
    std::vector<Problem> problems_;
};

/// The number of one-letter changes, insertions, deletions and swaps of neighbours that turn `a` into `b`.
[[nodiscard]] int edit_distance(const std::string& a, const std::string& b);

/// "did you mean 'x'?" for the nearest candidate, or all candidates when none is near.
[[nodiscard]] std::string suggestion(const std::string& word, const std::vector<std::string>& candidates);

/// The nearest candidate, or empty when none is near enough to be a slip of the fingers.
[[nodiscard]] std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

} // namespace io

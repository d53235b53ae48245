// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The lines that a run prints and keeps: a console with one status line at its end, and a log file with times.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <string>

namespace io {

/// "42 s", "3 min 20 s", "2 h 05 min".
[[nodiscard]] std::string duration_text(double seconds);

/// Where lines go that a person reads while the run goes on. On a terminal the status is one line that changes in place.
class Console {
public:
    enum class Kind { terminal, plain, silent };
    Console(std::ostream& stream, Kind kind) : stream_(stream), kind_(kind) {}
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    [[nodiscard]] Kind kind() const { return kind_; }
    void line(const std::string& text);
    /// Replaces the status line; an ordinary line where lines cannot be replaced.
    void status(const std::string& text);

private:
    void clear_status();
    std::ostream& stream_;
    Kind kind_;
    bool has_status_ = false;
};

/// The standard output of this rank: a terminal or plain on rank 0, silent on the others.
[[nodiscard]] Console::Kind console_kind(int rank);

/// Writes every line to the console and, with the time since the start, to a file.
class Log {
public:
    /// @param file  Lines are added at its end; nothing is written to a file if the path is empty.
    /// @throws core::FileError if the file cannot be opened.
    Log(const std::filesystem::path& file, Console& console);

    void info(const std::string& text);
    void warning(const std::string& text);
    void error(const std::string& text);
    /// Only to the file.
    void note(const std::string& text);
    /// Time since this log was opened [s].
    [[nodiscard]] double seconds() const;

private:
    void write(const std::string& text);
    Console& console_;
    std::ofstream file_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace io

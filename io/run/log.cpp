// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/log.hpp"

#include "core/base/error.hpp"
#include "io/run/launch.hpp"
#include <cstdlib>
#include <fmt/format.h>
#include <ostream>
#include <unistd.h>

namespace io {

std::string duration_text(double seconds)
{
    const auto whole = static_cast<long long>(seconds + 0.5);
    if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    if (whole < 86400) return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
    return fmt::format("{} days {:02} h", whole / 86400, whole / 3600 % 24);
}

Console::Kind console_kind(int rank)
{
    if (rank != 0) return Console::Kind::silent;
    if (ranks_of_mpirun()) return std::getenv(terminal_variable) != nullptr ? Console::Kind::terminal : Console::Kind::plain;
    return isatty(STDOUT_FILENO) == 1 ? Console::Kind::terminal : Console::Kind::plain;
}

Console::~Console()
{
    if (has_status_) stream_ << '\n' << std::flush;
}

void Console::clear_status()
{
    if (has_status_) stream_ << "\r\033[K";
    has_status_ = false;
}

void Console::line(const std::string& text)
{
    if (kind_ == Kind::silent) return;
    clear_status();
    stream_ << text << '\n' << std::flush;
}

void Console::status(const std::string& text)
{
    if (kind_ != Kind::terminal) return line(text);
    clear_status();
    stream_ << text << std::flush;
    has_status_ = true;
}

Log::Log(const std::filesystem::path& file, Console& console) : console_(console)
{
    if (file.empty()) return;
    file_.open(file, std::ios::app);
    core::require<core::FileError>(file_.good(), fmt::format("the log {} cannot be written", file.string()));
}

double Log::seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

void Log::write(const std::string& text)
{
    note(text);
    console_.line(text);
}

void Log::note(const std::string& text)
{
    if (file_.is_open()) file_ << fmt::format("[{:10.2f} s] {}\n", seconds(), text) << std::flush;
}

void Log::info(const std::string& text) { write(text); }

void Log::warning(const std::string& text) { write("warning: " + text); }

void Log::error(const std::string& text) { write("error: " + text); }

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/progress.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace io {

namespace {

constexpr double terminal_pause = 0.2, plain_pause = 10.0; // [s]
constexpr double memory = 20.0;                            // [s] of real time over which the rate is averaged

} // namespace

std::string progress_text(const StepReport& report, double share, std::optional<double> seconds_left)
{
    std::string text = fmt::format("step {}  t {:.6g} s  dt {:.3g} s", report.step, report.time, report.time_step);
    if (!report.limit.empty()) text += fmt::format(" ({})", report.limit);
    if (report.cfl) text += fmt::format("  CFL {:.2f}", *report.cfl);
    if (report.residual) text += fmt::format("  residual {:.1e}", *report.residual);
    if (report.particles) text += fmt::format("  particles {}", *report.particles);
    text += fmt::format("  {:.0f} %", 100.0 * share);
    if (seconds_left) text += fmt::format("  {} left", duration_text(*seconds_left));
    return text;
}

Progress::Progress(double begin, double until, Console& console, Log& log) : begin_(begin), until_(until), console_(console), log_(log)
{
    last_.time = begin;
    printed_wall_ = noted_wall_ = -plain_pause; // the first step is shown
}

void Progress::step(const StepReport& report, double wall)
{
    const double passed = wall - last_wall_;
    if (passed > 0.0) {
        const double rate = (report.time - last_.time) / passed;
        const double weight = steps_ == 0 ? 1.0 : 1.0 - std::exp(-passed / memory);
        rate_ += weight * (rate - rate_);
    }
    ++steps_;
    last_ = report;
    last_wall_ = wall;
    const double pause = console_.kind() == Console::Kind::terminal ? terminal_pause : plain_pause;
    if (wall - printed_wall_ >= pause) print();
}

std::optional<double> Progress::seconds_left() const
{
    if (steps_ < 2 || rate_ <= 0.0) return {};
    return std::max(0.0, until_ - last_.time) / rate_;
}

void Progress::print()
{
    const double share = std::clamp((last_.time - begin_) / (until_ - begin_), 0.0, 1.0);
    const std::string text = progress_text(last_, share, seconds_left());
    console_.status(text);
    printed_wall_ = last_wall_;
    if (last_wall_ - noted_wall_ >= plain_pause) {
        log_.note(text);
        noted_wall_ = last_wall_;
    }
}

void Progress::finish()
{
    if (steps_ > 0 && printed_wall_ != last_wall_) print();
}

} // namespace io

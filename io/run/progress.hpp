// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far a run is: one status line with step, time, limits, residual and the time it still needs.
#include "io/run/log.hpp"
#include <cstdint>
#include <optional>

namespace io {

/// What a step reports.
struct StepReport {
    std::int64_t step = 0;
    double time = 0.0, time_step = 0.0; ///< [s]
    std::optional<double> cfl;          ///< Largest number of cells crossed.
    std::optional<double> residual;     ///< Relative residual of the pressure.
    std::optional<std::int64_t> particles;
    std::string limit = {}; ///< Which limit rules the time step.
};

/// "step 120  t 0.0123 s  dt 1.2e-04 s  CFL 0.80  residual 3e-09  particles 1600  42 %  3 min 20 s left".
[[nodiscard]] std::string progress_text(const StepReport& report, double share, std::optional<double> seconds_left);

/// Estimates the time left and prints the status: five times a second on a terminal, every ten seconds elsewhere.
class Progress {
public:
    /// @param begin, until  Simulated time of the run [s].
    Progress(double begin, double until, Console& console, Log& log);

    /// @param wall  Real time since the run began [s].
    void step(const StepReport& report, double wall);
    /// Prints the last step whenever it was.
    void finish();
    /// Time left by the recent rate [s]; nothing before two steps.
    [[nodiscard]] std::optional<double> seconds_left() const;

private:
    void print();
    double begin_, until_;
    Console& console_;
    Log& log_;
    StepReport last_;
    double last_wall_ = 0.0, printed_wall_ = 0.0, noted_wall_ = 0.0;
    double rate_ = 0.0; ///< simulated over real time
    std::int64_t steps_ = 0;
};

} // namespace io

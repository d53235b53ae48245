// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// When an output is due: never, or each time that an interval of simulated time, wall time or steps has passed.
#include "core/comm/communicator.hpp"
#include "io/scene/value.hpp"
#include <cmath>
#include <cstring>

namespace io {

/// Where a run is after a step.
struct Moment {
    double time = 0.0; ///< simulated [s]
    std::int64_t step = 0;
    double wall = 0.0; ///< real time since the start of the program [s]; that of rank 0 counts
};

/// Simulated intervals and intervals of steps are counted from the start of the scene, so that a restart goes on with the
/// same numbers. Wall intervals are counted from the start of the program and only decide when something is written.
class IntervalClock {
public:
    IntervalClock(const Interval& interval, const core::Communicator& ranks) : interval_(interval), ranks_(ranks) {}

    /// Is an output due? True once for each interval, and for the moment t = 0 of simulated intervals and steps. Collective.
    [[nodiscard]] bool due(const Moment& now)
    {
        if (interval_.clock == Interval::Clock::never) return false;
        const std::int64_t index = index_of(now);
        if (index <= last_) return false;
        last_ = index;
        number_ = interval_.clock == Interval::Clock::wall ? now.step : index;
        return true;
    }
    /// Everything up to `now` has been written by an earlier run.
    void resume(const Moment& now)
    {
        if (interval_.clock != Interval::Clock::wall && interval_.clock != Interval::Clock::never) last_ = index_of(now);
    }
    /// Number of the output that was due last: the interval's, or the step's for wall intervals.
    [[nodiscard]] std::int64_t number() const { return number_; }

private:
    [[nodiscard]] std::int64_t index_of(const Moment& now) const
    {
        constexpr double tiny = 1e-6; // of an interval: times are sums of steps and carry their rounding
        const auto count = [&](double x) { return std::int64_t(std::floor(x / interval_.every + tiny)); };
        if (interval_.clock == Interval::Clock::simulated) return count(now.time);
        if (interval_.clock == Interval::Clock::steps) return count(double(now.step));
        std::vector<std::byte> wall(sizeof now.wall);
        std::memcpy(wall.data(), &now.wall, sizeof now.wall);
        if (ranks_.size() > 1) ranks_.broadcast(wall, 0);
        double seconds = 0;
        std::memcpy(&seconds, wall.data(), sizeof seconds);
        return count(seconds) - 1; // nothing is due at the start
    }

    Interval interval_;
    core::Communicator ranks_;
    std::int64_t last_ = -1, number_ = 0;
};

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How something that a scene gives changes in time: a factor, by a formula or by points in a table.
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace physics {

/// 1 at all times.
struct SteadyCourse {
    bool operator==(const SteadyCourse&) const = default;
};

/// mean + amplitude cos(angular_frequency t + phase)
struct HarmonicCourse {
    double mean = 0;
    double amplitude = 1;
    double angular_frequency = 1; ///< [rad/s]
    double phase = 0;             ///< [rad]
    bool operator==(const HarmonicCourse&) const = default;
};

/// Through given points: straight lines, or cubics that have no extremes but those of the points.
class TableCourse {
public:
    enum class Between { linear, cubic };
    enum class Beyond { hold, repeat }; ///< outside the table: its last (or first) value, or the table again
    struct Point {
        double time; ///< [s]
        double value;
        bool operator==(const Point&) const = default;
    };
    /// @throws core::ConfigError unless times increase and are at least two; to repeat, the last value must be the first.
    TableCourse(std::vector<Point> points, Between between, Beyond beyond);

    [[nodiscard]] double value(double time) const;
    /// Integral from `begin` to `end`, to round-off: piece by piece, each a cubic [s].
    [[nodiscard]] double integral(double begin, double end) const;
    [[nodiscard]] double largest_magnitude() const;
    bool operator==(const TableCourse&) const = default;

private:
    /// Pieces are counted from the first time of the table on, through all repetitions.
    [[nodiscard]] std::int64_t piece_at(double time) const;
    [[nodiscard]] double start_of(std::int64_t piece) const;
    [[nodiscard]] double value_in(std::int64_t piece, double time) const;
    /// The repetition that a piece lies in, and its place in the table.
    [[nodiscard]] std::pair<std::int64_t, std::size_t> place_of(std::int64_t piece) const;
    [[nodiscard]] std::int64_t pieces() const { return std::int64_t(points_.size()) - 1; }
    [[nodiscard]] double period() const { return points_.back().time - points_.front().time; }

    std::vector<Point> points_;
    std::vector<double> low_slope_, high_slope_; ///< of each piece at its ends [1/s]
    Beyond beyond_;
};

using TimeCourse = std::variant<SteadyCourse, HarmonicCourse, TableCourse>;

[[nodiscard]] double value_at(const TimeCourse& course, double time);
/// Mean over [time, time + dt], exact; dt may be tiny or many periods.
[[nodiscard]] double mean_value(const TimeCourse& course, double time, double dt);
/// Largest |value| at any time.
[[nodiscard]] double largest_magnitude(const TimeCourse& course);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/time_course.hpp"
#include "core/base/error.hpp"
#include "core/base/overloaded.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace physics {
namespace {

/// Slope at a point between two pieces that makes a cubic Hermite interpolant monotone.
/// @source  Fritsch & Butland (1984), SIAM J. Sci. Stat. Comput. 5, 300, eq. (4), with Brodlie's weights.
double monotone_slope(double low_length, double high_length, double low_slope, double high_slope)
{
    if (low_slope * high_slope <= 0) return 0;
    const double share = (low_length + 2 * high_length) / (3 * (low_length + high_length));
    return low_slope * high_slope / (share * high_slope + (1 - share) * low_slope);
}

void require_order(const std::vector<TableCourse::Point>& points)
{
    core::require<core::ConfigError>(points.size() >= 2, "a table in time needs at least two points");
    for (std::size_t n = 1; n < points.size(); ++n)
        core::require<core::ConfigError>(
            points[n].time > points[n - 1].time,
            core::text("the times of a table must increase: ", points[n].time, " s follows ", points[n - 1].time, " s"));
}

} // namespace

TableCourse::TableCourse(std::vector<Point> points, Between between, Beyond beyond) : points_(std::move(points)), beyond_(beyond)
{
    require_order(points_);
    const bool repeats = beyond == Beyond::repeat;
    core::require<core::ConfigError>(!repeats || points_.back().value == points_.front().value,
                                     "a table that repeats must end with the value that it begins with");
    const std::size_t count = points_.size() - 1;
    std::vector<double> length(count), slope(count);
    for (std::size_t n = 0; n < count; ++n) {
        length[n] = points_[n + 1].time - points_[n].time;
        slope[n] = (points_[n + 1].value - points_[n].value) / length[n];
    }
    low_slope_ = high_slope_ = slope;
    if (between == Between::linear) return;
    const auto at = [&](std::size_t low, std::size_t high) { return monotone_slope(length[low], length[high], slope[low], slope[high]); };
    for (std::size_t n = 1; n < count; ++n) high_slope_[n - 1] = low_slope_[n] = at(n - 1, n);
    // A table that is held goes on level beyond its ends.
    low_slope_.front() = high_slope_.back() = repeats ? at(count - 1, 0) : 0.0;
}

std::pair<std::int64_t, std::size_t> TableCourse::place_of(std::int64_t piece) const
{
    const std::int64_t n = pieces(), within = ((piece % n) + n) % n;
    return {(piece - within) / n, std::size_t(within)};
}

double TableCourse::start_of(std::int64_t piece) const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (beyond_ == Beyond::hold) {
        if (piece < 0) return -infinity;
        return piece > pieces() ? infinity : points_[std::size_t(piece)].time;
    }
    const auto [cycle, within] = place_of(piece);
    return points_[within].time + double(cycle) * period();
}

std::int64_t TableCourse::piece_at(double time) const
{
    const double cycle = beyond_ == Beyond::repeat ? std::floor((time - points_.front().time) / period()) : 0.0;
    const double local = time - cycle * period();
    const auto above = std::upper_bound(points_.begin(), points_.end(), local, [](double t, const Point& p) { return t < p.time; });
    const std::int64_t piece = (above - points_.begin()) - 1;
    return beyond_ == Beyond::hold ? piece : std::clamp<std::int64_t>(piece, 0, pieces() - 1) + std::int64_t(cycle) * pieces();
}

double TableCourse::value_in(std::int64_t piece, double time) const
{
    if (beyond_ == Beyond::hold && piece < 0) return points_.front().value;
    if (beyond_ == Beyond::hold && piece >= pieces()) return points_.back().value;
    const std::size_t n = place_of(piece).second;
    const double length = points_[n + 1].time - points_[n].time, x = std::clamp((time - start_of(piece)) / length, 0.0, 1.0), y = 1 - x;
    return y * y * ((1 + 2 * x) * points_[n].value + x * length * low_slope_[n]) +
           x * x * ((1 + 2 * y) * points_[n + 1].value - y * length * high_slope_[n]);
}

double TableCourse::value(double time) const { return value_in(piece_at(time), time); }

double TableCourse::integral(double begin, double end) const
{
    double sum = 0;
    for (std::int64_t piece = piece_at(begin), last = piece_at(end); piece <= last; ++piece) {
        const double a = std::max(begin, start_of(piece)), b = std::min(end, start_of(piece + 1));
        // Simpson's rule integrates cubics exactly.
        if (b > a) sum += (b - a) / 6 * (value_in(piece, a) + 4 * value_in(piece, 0.5 * (a + b)) + value_in(piece, b));
    }
    return sum;
}

double TableCourse::largest_magnitude() const
{
    double largest = 0;
    for (const Point& p : points_) largest = std::max(largest, std::abs(p.value));
    return largest;
}

double value_at(const TimeCourse& course, double time)
{
    return std::visit(core::Overloaded{
                          [](const SteadyCourse&) { return 1.0; },
                          [&](const HarmonicCourse& c) { return c.mean + c.amplitude * std::cos(c.angular_frequency * time + c.phase); },
                          [&](const TableCourse& c) { return c.value(time); },
                      },
                      course);
}

double mean_value(const TimeCourse& course, double time, double dt)
{
    return std::visit(core::Overloaded{
                          [](const SteadyCourse&) { return 1.0; },
                          [&](const HarmonicCourse& c) {
                              // Mean of a cosine: its value at mid-step times sin(h) / h, h half the phase of the step.
                              const double half = 0.5 * c.angular_frequency * dt;
                              const double middle = std::cos(c.angular_frequency * time + half + c.phase);
                              return c.mean + c.amplitude * middle * (half == 0 ? 1 : std::sin(half) / half);
                          },
                          [&](const TableCourse& c) {
                              const double end = time + dt, length = end - time; // as rounded: late and tiny steps
                              return length > 0 ? c.integral(time, end) / length : c.value(time);
                          },
                      },
                      course);
}

double largest_magnitude(const TimeCourse& course)
{
    return std::visit(core::Overloaded{
                          [](const SteadyCourse&) { return 1.0; },
                          [](const HarmonicCourse& c) { return std::abs(c.mean) + std::abs(c.amplitude); },
                          [](const TableCourse& c) { return c.largest_magnitude(); },
                      },
                      course);
}

} // namespace physics

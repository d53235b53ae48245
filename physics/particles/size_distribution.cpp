// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/size_distribution.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace physics {
namespace {

using core::require, core::ConfigError, core::text;
using Interval = SizeIntervals::Interval;

void require_rising(const std::vector<SizePoint>& points)
{
    for (std::size_t n = 0; n < points.size(); ++n) {
        require<ConfigError>(points[n].diameter > 0, text("a diameter of ", points[n].diameter, " m is not positive"));
        require<ConfigError>(n == 0 || points[n].diameter > points[n - 1].diameter,
                             text("diameters must rise, and ", points[n].diameter, " m follows ", points[n - 1].diameter, " m"));
    }
}

/// Makes what passes each interval, now its own amount, a share of all.
SizeDistribution summed(std::vector<Interval> intervals)
{
    double sum = 0;
    for (Interval& interval : intervals) interval.passing = sum += interval.passing;
    require<ConfigError>(sum > 0, "the shares of all diameters are zero");
    for (Interval& interval : intervals) interval.passing /= sum;
    return SizeIntervals{std::move(intervals)};
}

double normal_passing(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// Where the normal distribution has let pass `wanted`, between `low` and `high`: by bisection, to the last bit.
double normal_at(double wanted, double low, double high)
{
    for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
        (normal_passing(middle) < wanted ? low : high) = middle;
    return low;
}

double at(const SizeIntervals& sizes, double passing)
{
    const auto& all = sizes.intervals;
    const auto found = std::find_if(all.begin(), all.end() - 1, [&](const Interval& i) { return passing < i.passing; });
    const double before = found == all.begin() ? 0.0 : std::prev(found)->passing, own = found->passing - before;
    const double inside = own > 0 ? std::clamp((passing - before) / own, 0.0, 1.0) : 0.0;
    if (found->low == found->high) return found->low;
    const double ratio = found->high / found->low;
    if (found->power == 0) return found->low * std::pow(ratio, inside);
    return found->low * std::pow(1.0 + inside * (std::pow(ratio, found->power) - 1.0), 1.0 / found->power);
}

double at(const LognormalSizes& sizes, double passing)
{
    const double deviation = std::log(sizes.deviation);
    const double low = std::log(sizes.smallest / sizes.median) / deviation, high = std::log(sizes.largest / sizes.median) / deviation;
    const double below = normal_passing(low), above = normal_passing(high);
    const double x = normal_at(below + passing * (above - below), low, high);
    return std::clamp(sizes.median * std::exp(deviation * x), sizes.smallest, sizes.largest);
}

} // namespace

SizeDistribution listed_sizes(const std::vector<SizePoint>& points, ShareOf share)
{
    require_rising(points);
    std::vector<Interval> intervals;
    for (const auto& [d, part] : points) {
        require<ConfigError>(part >= 0, text("the share ", part, " of ", d, " m is negative"));
        intervals.push_back({d, d, share == ShareOf::mass ? part / (d * d * d) : part, 0.0});
    }
    return summed(std::move(intervals));
}

SizeDistribution sieved_sizes(const std::vector<SizePoint>& passing, ShareOf share)
{
    require_rising(passing);
    require<ConfigError>(passing.size() > 1 && passing.front().share == 0 && passing.back().share == 1,
                         "what passes a sieve must go from 0 at the smallest diameter to 1 at the largest");
    std::vector<Interval> intervals;
    for (std::size_t n = 1; n < passing.size(); ++n) {
        const auto& [low, below] = passing[n - 1];
        const auto& [high, above] = passing[n];
        require<ConfigError>(above >= below, text("what passes must not fall, and it does at ", high, " m"));
        // Mass even in ln d: the number of a piece d ln d of mass goes with d^-3 d ln d.
        const double per_mass = (std::pow(low, -3) - std::pow(high, -3)) / (3.0 * std::log(high / low));
        if (share == ShareOf::mass) intervals.push_back({low, high, (above - below) * per_mass, -3.0});
        else intervals.push_back({low, high, above - below, 0.0});
    }
    return summed(std::move(intervals));
}

SizeDistribution lognormal_sizes(const LognormalSizes& sizes, ShareOf share)
{
    require<ConfigError>(sizes.median > 0, text("a median of ", sizes.median, " m is not positive"));
    require<ConfigError>(sizes.deviation > 1, text("a geometric standard deviation of ", sizes.deviation, " is not above 1"));
    require<ConfigError>(
        sizes.smallest > 0 && sizes.smallest < sizes.largest,
        text("the smallest diameter, ", sizes.smallest, " m, must be positive and below the largest, ", sizes.largest, " m"));
    LognormalSizes of_number = sizes;
    const double deviation = std::log(sizes.deviation);
    if (share == ShareOf::mass) of_number.median *= std::exp(-3.0 * deviation * deviation);
    const double most = 8.0 * deviation; // beyond it a normal distribution has nothing that doubles resolve
    require<ConfigError>(
        std::log(sizes.smallest / of_number.median) < most && std::log(of_number.median / sizes.largest) < most,
        text("no diameter lies between ", sizes.smallest, " and ", sizes.largest, " m: the median of number is ", of_number.median, " m"));
    return of_number;
}

double diameter_at(const SizeDistribution& sizes, double passing)
{
    return std::visit([&](const auto& s) { return at(s, passing); }, sizes);
}

std::vector<double> diameters_of(const SizeDistribution& sizes, int count)
{
    std::vector<double> all;
    all.reserve(std::size_t(count));
    for (int n = 0; n < count; ++n) all.push_back(diameter_at(sizes, (n + 0.5) / count));
    return all;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How the diameters of a species are distributed: listed, lognormal, or by a sieve curve; shares of number or of mass.
#include <variant>
#include <vector>

namespace physics {

/// What the shares of a distribution are shares of. Within a species mass goes with the cube of the diameter.
enum class ShareOf { number, mass };

/// A diameter with what belongs to it: its share, or the share of all that is not larger.
struct SizePoint {
    double diameter = 0.0; ///< [m]
    double share = 0.0;    ///< [-]
};

/// Diameters in intervals, each with its share of the number of particles.
struct SizeIntervals {
    struct Interval {
        double low, high; ///< [m]; equal for a single diameter.
        double passing;   ///< Share of the number of particles up to the end of the interval [-].
        double power;     ///< Within it the number density goes with diameter^(power - 1): 0, or -3 where mass is even in its logarithm.
    };
    std::vector<Interval> intervals;
};

/// The logarithm of the diameter is normal between two ends.
struct LognormalSizes {
    double median = 0.0;                ///< Of the number of particles, before the ends are cut off [m].
    double deviation = 1.0;             ///< Geometric standard deviation, above 1 [-].
    double smallest = 0.0, largest = 0; ///< [m]
};

using SizeDistribution = std::variant<SizeIntervals, LognormalSizes>;

/// Listed diameters with shares that need not sum to 1.
/// @throws core::ConfigError unless diameters are positive and rise, and shares are not negative and not all zero.
[[nodiscard]] SizeDistribution listed_sizes(const std::vector<SizePoint>& points, ShareOf share);

/// A sieve curve: the share that passes each diameter, from 0 to 1, straight between them over the logarithm of the diameter.
/// @throws core::ConfigError unless diameters are positive and rise, and what passes rises from 0 to 1.
[[nodiscard]] SizeDistribution sieved_sizes(const std::vector<SizePoint>& passing, ShareOf share);

/// Lognormal sizes; a median of mass is made one of number.
/// @throws core::ConfigError for a deviation of at most 1 or ends out of order.
/// @source  Hatch & Choate (1929), J. Franklin Inst. 207: ln(median of number) = ln(median of mass) - 3 ln^2(deviation).
[[nodiscard]] SizeDistribution lognormal_sizes(const LognormalSizes& sizes, ShareOf share);

/// The diameter that the share `passing`, 0..1, of the number of particles does not exceed [m].
[[nodiscard]] double diameter_at(const SizeDistribution& sizes, double passing);

/// The diameters of `count` particles, rising: the best that so many can do, at the middle of each of `count` equal shares.
[[nodiscard]] std::vector<double> diameters_of(const SizeDistribution& sizes, int count);

} // namespace physics

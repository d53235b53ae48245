// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Large grains above small ones, and waves of the bed that they form.
#include "io/files/exact_sums.hpp"
#include "io/run/metric_groups.hpp"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace io {
namespace {

constexpr int longest_waves = 4;

/// Difference of the mean heights over the mean diameter of the large; 0 unless there are both [-].
double large_above_small(const World& world)
{
    const core::ParticleSet& p = world.grains()->particles;
    const core::Vec3 up = -world.scene().gravity->direction.normalized(), origin = world.grains()->domain().origin;
    const double middle = 0.25 * (world.census().smallest + world.census().largest); // a radius
    std::vector<std::vector<double>> columns(5); // number and height of small and large, diameter of large
    for (int i = 0; i < p.owned; ++i) {
        const double radius = p.radius[std::size_t(i)];
        const bool large = radius > middle;
        columns[large ? 2 : 0].push_back(1.0);
        columns[large ? 3 : 1].push_back(up.dot(origin + p.position_of(i)));
        if (large) columns[4].push_back(2 * radius);
    }
    const auto sums = exact_sums(world.ranks(), columns);
    return sums[0] > 0 && sums[2] > 0 ? (sums[3] / sums[2] - sums[1] / sums[0]) / (sums[4] / sums[2]) : 0.0;
}

/// Amplitudes of waves of the volume of grains per length, over its mean [-].
std::array<double, longest_waves> waves_along(const World& world, int axis)
{
    const core::ParticleSet& p = world.grains()->particles;
    const double number = 2 * std::numbers::pi / world.grains()->domain().size[axis];
    std::vector<std::vector<double>> columns(1 + 2 * longest_waves);
    for (int i = 0; i < p.owned; ++i) {
        const double cube = std::pow(p.radius[std::size_t(i)], 3), angle = number * p.position_of(i)[axis];
        columns[0].push_back(cube);
        for (int n = 1; n <= longest_waves; ++n) {
            columns[std::size_t(2 * n - 1)].push_back(cube * std::cos(n * angle));
            columns[std::size_t(2 * n)].push_back(cube * std::sin(n * angle));
        }
    }
    const auto sums = exact_sums(world.ranks(), columns);
    std::array<double, longest_waves> amplitudes{};
    for (std::size_t n = 0; n < longest_waves; ++n)
        if (sums[0] > 0) amplitudes[n] = 2 * std::hypot(sums[2 * n + 1], sums[2 * n + 2]) / sums[0];
    return amplitudes;
}

} // namespace

MetricGroup segregation_metrics(World& world)
{
    std::vector<std::string> names{"segregation"};
    std::vector<int> level;
    for (int axis = 0; axis < 3; ++axis) {
        if (!world.scene().grid.is_periodic(axis) || std::abs(world.scene().gravity->direction.normalized()[axis]) > 0.5) continue;
        level.push_back(axis);
        for (int n = 1; n <= longest_waves; ++n) names.push_back(fmt::format("waves_{}_{}", "xyz"[axis], n));
    }
    return {names, [&world, level] {
                std::vector<double> values{large_above_small(world)};
                for (const int axis : level)
                    for (const double amplitude : waves_along(world, axis)) values.push_back(amplitude);
                return values;
            }};
}

} // namespace io

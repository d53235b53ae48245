// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/grain_census.hpp"
#include "core/base/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace io {
namespace {

/// Diameter that `share` of the mass does not exceed [m]. @param diameters  rising
double passed_by(const std::vector<double>& diameters, double share)
{
    double all = 0, passing = 0;
    for (const double d : diameters) all += d * d * d;
    for (const double d : diameters)
        if (passing += d * d * d; passing >= share * all) return d;
    return diameters.back();
}

} // namespace

void GrainCensus::add(const core::Sphere& grain)
{
    const double d = 2 * grain.radius, cube = d * d * d;
    ++count;
    cubes += cube;
    mass += std::numbers::pi / 6 * cube * grain.density;
    volume += std::numbers::pi / 6 * cube;
    stretch(d, grain.density);
}

void GrainCensus::stretch(double diameter, double density)
{
    smallest = std::min(smallest, diameter);
    largest = std::max(largest, diameter);
    least_density = std::min(least_density, density);
}

double GrainCensus::mean_diameter() const
{
    return count > 0 ? std::cbrt(cubes / double(count)) : arriving > 0 ? std::cbrt(arriving_cubes / arriving) : 0.0;
}

double GrainCensus::mean_mass() const
{
    if (count > 0) return mass / double(count);
    return arriving > 0 ? std::numbers::pi / 6 * arriving_cubes / arriving * least_density : 0.0;
}

std::vector<double> diameters_of(const Species& species)
{
    return species.sizes ? physics::diameters_of(species.sizes->distribution(), *species.count) : std::vector{*species.diameter};
}

bool has_sizes(const Species& species)
{
    try {
        if (species.sizes) (void)species.sizes->distribution();
        return species.sizes || species.diameter;
    } catch (const core::ConfigError&) {
        return false;
    }
}

double mean_cube(const Species& species)
{
    constexpr int enough = 10000;
    if (!species.sizes) return std::pow(*species.diameter, 3);
    const std::vector<double> sample =
        physics::diameters_of(species.sizes->distribution(), std::clamp(species.count.value_or(enough), 1, enough));
    double sum = 0;
    for (const double d : sample) sum += d * d * d;
    return sum / double(sample.size());
}

std::array<double, 2> size_range(const Species& species)
{
    if (!species.sizes) return {*species.diameter, *species.diameter};
    const physics::SizeDistribution sizes = species.sizes->distribution();
    return {physics::diameter_at(sizes, 0.0), physics::diameter_at(sizes, 1.0)};
}

GrainCensus census_of(const Scene& scene)
{
    GrainCensus census;
    for (const Species& s : scene.particles) {
        if (!s.file.empty()) continue;
        const double each = s.sizes ? 1 : *s.count;
        for (const double d : diameters_of(s)) {
            const double cube = std::pow(d, 3), mass = std::numbers::pi / 6 * cube * s.density;
            census.cubes += each * cube;
            census.mass += each * mass;
            census.volume += each * mass / s.density;
            census.stretch(d, s.density);
        }
        census.count += *s.count;
        if (!s.inflow) continue;
        for (const double d : size_range(s)) census.stretch(d, s.density);
        census.arriving_cubes += mean_cube(s);
        ++census.arriving;
    }
    return census;
}

std::string size_report(const Scene& scene)
{
    std::string text;
    for (const Species& s : scene.particles) {
        if (!s.sizes || s.count.value_or(0) == 0) continue;
        const std::vector<double> d = diameters_of(s);
        text +=
            fmt::format("{}: {} of {:.4g} to {:.4g} mm; 10, 50 and 90 % of the mass up to {:.4g}, {:.4g} and {:.4g} mm\n", s.name, *s.count,
                        1e3 * d.front(), 1e3 * d.back(), 1e3 * passed_by(d, 0.1), 1e3 * passed_by(d, 0.5), 1e3 * passed_by(d, 0.9));
    }
    return text;
}

} // namespace io

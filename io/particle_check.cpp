// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of the species of a scene: their names, sizes, regions and room.
#include "core/base/error.hpp"
#include "io/grain_census.hpp"
#include "io/scene_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace io {

namespace {

/// Random placing without overlaps jams near a fraction of 0.38 in space; below this bound it is quick.
constexpr double largest_random_fraction = 0.32;

class ParticleChecker {
public:
    ParticleChecker(const Scene& scene, const Locations& locations, Problems& problems)
        : scene_(scene), locations_(locations), problems_(problems)
    {
    }

    void check()
    {
        for (std::size_t n = 0; n < scene_.particles.size(); ++n) check_species(n);
    }

private:
    void complain(const std::string& path, const std::string& message, const std::string& hint)
    {
        problems_.add(locations_.at(path), message, hint);
    }

    [[nodiscard]] bool all_good(const std::vector<std::string>& paths) const
    {
        return std::all_of(paths.begin(), paths.end(), [&](const auto& path) { return locations_.good(path); });
    }

    [[nodiscard]] core::Vec3 low_of(const Species& species) const
    {
        return species.initial.low.value_or(margin(species, scene_.grid.low(), 0.5));
    }
    [[nodiscard]] core::Vec3 high_of(const Species& species) const
    {
        return species.initial.high.value_or(margin(species, scene_.grid.high(), -0.5));
    }
    /// A corner of the domain moved by a share of the largest diameter along the axes that have walls.
    [[nodiscard]] core::Vec3 margin(const Species& species, core::Vec3 corner, double share) const
    {
        for (int axis = 0; axis < 3; ++axis)
            if (!scene_.grid.is_periodic(axis)) corner[axis] += share * size_range(species)[1];
        return corner;
    }

    void check_species(std::size_t n)
    {
        const Species& species = scene_.particles[n];
        const std::string path = fmt::format("particles.{}", n);
        for (std::size_t m = 0; m < n; ++m)
            if (all_good({path + ".name"}) && scene_.particles[m].name == species.name)
                complain(path + ".name", fmt::format("two species are named '{}'", species.name), "give each its own name");
        if (!check_sizes(species, path) || !all_good({"grid", path + ".diameter", path + ".initial"})) return;
        const core::Vec3 domain = scene_.grid.high() - scene_.grid.low();
        if (size_range(species)[1] >= domain.minCoeff())
            return complain(path + (species.sizes ? ".sizes" : ".diameter"), "the particles are larger than the domain",
                            fmt::format("the domain is {} m wide", number_text(domain.minCoeff())));
        if (check_region(species, path) && all_good({path + ".count", "particles"})) check_fraction(n, path);
    }

    /// Is there a diameter, or sizes that are a distribution?
    [[nodiscard]] bool check_sizes(const Species& species, const std::string& path)
    {
        if (!locations_.good(path + ".sizes")) return false;
        if (!species.sizes) return species.diameter.has_value();
        try {
            (void)species.sizes->distribution();
            return true;
        } catch (const core::ConfigError& error) {
            complain(path + ".sizes", error.what(), "");
            return false;
        }
    }

    [[nodiscard]] bool check_region(const Species& species, const std::string& path)
    {
        const std::size_t before = problems_.size();
        const core::Vec3 low = low_of(species), high = high_of(species);
        const core::Vec3 first = margin(species, scene_.grid.low(), 0.5);
        const core::Vec3 last = margin(species, scene_.grid.high(), -0.5);
        for (int axis = 0; axis < 3; ++axis) {
            const auto name = axis_words[std::size_t(axis) + 1];
            const double slack = 1e-9 * (last[axis] - first[axis]); // round-off of corners given in decimals
            if (low[axis] > high[axis])
                complain(path + ".initial.low", fmt::format("'low' is above 'high' along {}", name), "exchange the two");
            const std::string room =
                fmt::format("along {} centres must lie from {} m to {} m", name, number_text(first[axis]), number_text(last[axis]));
            if (low[axis] < first[axis] - slack) complain(path + ".initial.low", "particles would be outside the domain", room);
            if (high[axis] > last[axis] + slack) complain(path + ".initial.high", "particles would be outside the domain", room);
        }
        return problems_.size() == before;
    }

    /// Volume of a region within reach of its particles, at most the domain's.
    [[nodiscard]] double room_of(const Species& species) const
    {
        const core::Vec3 low = margin(species, low_of(species), -0.5), high = margin(species, high_of(species), 0.5);
        return std::min((high - low).prod(), scene_.grid.volume());
    }

    void check_fraction(std::size_t n, const std::string& path)
    {
        const Species& species = scene_.particles[n];
        if (species.initial.arrangement != Arrangement::random) return;
        double volume = 0.0;
        for (std::size_t m = 0; m <= n; ++m)
            if (const Species& other = scene_.particles[m];
                has_sizes(other) && other.initial.low == species.initial.low && other.initial.high == species.initial.high)
                volume += other.count * std::numbers::pi / 6.0 * mean_cube(other);
        const double fraction = volume / room_of(species);
        if (fraction > largest_random_fraction)
            complain(path + ".count", fmt::format("the particles would fill {:.0f} % of their region", 100.0 * fraction),
                     fmt::format("random placing needs less than {:.0f} %: take fewer, a larger region, or "
                                 "arrangement: lattice",
                                 100.0 * largest_random_fraction));
    }

    const Scene& scene_;
    const Locations& locations_;
    Problems& problems_;
};

} // namespace

void check_particles(const Scene& scene, const Locations& locations, Problems& problems)
{
    ParticleChecker(scene, locations, problems).check();
}

} // namespace io

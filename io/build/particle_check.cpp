// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of the species of a scene: their names, sizes, regions and room.
#include "core/base/error.hpp"
#include "io/build/grain_census.hpp"
#include "io/build/placement_room.hpp"
#include "io/scene/scene_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace io {

namespace {

/// Random placing without overlaps jams near a fraction of 0.38 in space; below this bound it is quick.
constexpr double largest_random_fraction = 0.32;
/// Face-centred cubes of equal spheres; wide distributions reach it at random.
constexpr double densest_fraction = 0.74;

class ParticleChecker {
public:
    ParticleChecker(const Scene& scene, const Locations& locations, Problems& problems)
        : scene_(scene), locations_(locations), problems_(problems)
    {
    }

    void check()
    {
        for (std::size_t n = 0; n < scene_.particles.size(); ++n) check_species(n);
        check_outlets();
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

    void check_species(std::size_t n)
    {
        const Species& species = scene_.particles[n];
        const std::string path = fmt::format("particles.{}", n);
        for (std::size_t m = 0; m < n; ++m)
            if (all_good({path + ".name"}) && scene_.particles[m].name == species.name)
                complain(path + ".name", fmt::format("two species are named '{}'", species.name), "give each its own name");
        if (!species.file.empty()) return;
        if (!check_sizes(species, path) || !all_good({"grid", path + ".diameter", path + ".initial"})) return;
        const core::Vec3 domain = scene_.grid.high() - scene_.grid.low();
        if (size_range(species)[1] >= domain.minCoeff())
            return complain(path + (species.sizes ? ".sizes" : ".diameter"), "the particles are larger than the domain",
                            fmt::format("the domain is {} m wide", number_text(domain.minCoeff())));
        check_resolution(species, path + (species.sizes ? ".sizes" : ".diameter"));
        if (check_region(species, path) && all_good({path + ".count", "particles"})) check_fraction(n, path);
        if (species.inflow) check_inflow(species, path + ".inflow");
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

    /// Do numbers as large as coordinates in the domain tell overlaps of such small particles apart?
    void check_resolution(const Species& species, const std::string& path)
    {
        constexpr double finest = 1e-9; // of a diameter: a hundred-thousandth of a usual overlap
        const double farthest = std::max(scene_.grid.low().cwiseAbs().maxCoeff(), scene_.grid.high().cwiseAbs().maxCoeff());
        const double apart = farthest * std::numeric_limits<double>::epsilon();
        if (apart > finest * size_range(species)[0])
            complain(path,
                     fmt::format("{} m from the origin, places are known to {:.1g} m only: too coarse for contacts of such small particles",
                                 number_text(farthest), apart),
                     "move the grid to the origin, or make it smaller");
    }

    [[nodiscard]] bool check_region(const Species& species, const std::string& path)
    {
        const std::size_t before = problems_.size();
        if (!check_form(species.initial.region, path + ".initial")) return false;
        const core::Vec3 low = low_of(scene_, species), high = high_of(scene_, species);
        const core::Vec3 first = moved_corner(scene_, species, scene_.grid.low(), 0.5);
        const core::Vec3 last = moved_corner(scene_, species, scene_.grid.high(), -0.5);
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

    /// Is the region a box, a cylinder or a sphere, and not two of them?
    [[nodiscard]] bool check_form(const RegionKeys& region, const std::string& path)
    {
        const std::size_t before = problems_.size();
        const auto excludes = [&](const char* key, const char* other) {
            complain(path + "." + key, fmt::format("'{}' excludes '{}'", key, other), "keep one of the two");
        };
        if (region.cylinder && region.sphere) excludes("sphere", "cylinder");
        if (region.is_round() && (region.low || region.high))
            excludes(region.low ? "low" : "high", region.cylinder ? "cylinder" : "sphere");
        if (region.cylinder && region.cylinder->from == region.cylinder->to)
            complain(path + ".cylinder", "the cylinder has no length: 'from' is 'to'", "move one of them along the axis");
        return problems_.size() == before;
    }

    /// Does a region lie in the domain, as a whole?
    void check_whole(const RegionKeys& region, const std::string& path)
    {
        if (!locations_.good(path) || !check_form(region, path)) return;
        if (!region.is_whole()) return complain(path, "a region is needed", "give low and high, or a cylinder, or a sphere");
        const auto outside = [&](const core::Vec3& x) {
            return (x.array() < scene_.grid.low().array()).any() || (x.array() > scene_.grid.high().array()).any();
        };
        const auto check = [&](const core::Vec3& x, const char* key) {
            if (outside(x)) complain(path + "." + key, "the region is not inside the domain", "move it");
        };
        if (region.low && region.high && (region.low->array() > region.high->array()).any())
            complain(path + ".low", "'low' is above 'high'", "exchange the two");
        if (region.low) check(*region.low, "low");
        if (region.high) check(*region.high, "high");
        if (region.sphere) check(region.sphere->centre, "sphere");
        if (region.cylinder) check(0.5 * (region.cylinder->from + region.cylinder->to), "cylinder");
    }

    void check_inflow(const Species& species, const std::string& path)
    {
        check_whole(species.inflow->region, path);
        if (all_good({path + ".begin", path + ".end"}) && species.inflow->end && *species.inflow->end <= species.inflow->begin)
            complain(path + ".end", "the inflow ends before it begins", fmt::format("it begins at {} s", species.inflow->begin));
    }

    void check_outlets()
    {
        for (std::size_t n = 0; n < scene_.outlets.size(); ++n) {
            const std::string path = fmt::format("outlets.{}", n);
            for (std::size_t m = 0; m < n; ++m)
                if (scene_.outlets[m].name == scene_.outlets[n].name)
                    complain(path + ".name", fmt::format("two outlets are named '{}'", scene_.outlets[n].name), "give each its own name");
            if (locations_.good("grid")) check_whole(scene_.outlets[n].region, path);
        }
    }

    void check_fraction(std::size_t n, const std::string& path)
    {
        const Species& species = scene_.particles[n];
        const bool dense = species.initial.arrangement == Arrangement::dense;
        if (!dense && species.initial.arrangement != Arrangement::random) return;
        double volume = 0.0;
        std::int64_t count = 0;
        for (std::size_t m = 0; m <= n; ++m)
            if (const Species& other = scene_.particles[m]; has_sizes(other) && other.initial.region == species.initial.region) {
                volume += number_of(other) * std::numbers::pi / 6.0 * mean_cube(other);
                count += number_of(other);
            }
        if (count < 2) return; // one finds a place in any region
        const double fraction = volume / room_of(scene_, species), most = dense ? densest_fraction : largest_random_fraction;
        if (fraction > most)
            complain(path + (species.volume_fraction ? ".volume_fraction" : ".count"),
                     fmt::format("the particles would fill {:.0f} % of their region", 100.0 * fraction),
                     dense ? std::string("no packing is as dense: take fewer, or a larger region")
                           : fmt::format("random placing needs less than {:.0f} %: take fewer, a larger region, or "
                                         "arrangement: lattice or dense",
                                         100.0 * most));
    }

    [[nodiscard]] int number_of(const Species& species) const
    {
        return species.volume_fraction ? filling_count(scene_, species) : species.count.value_or(0);
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

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of a scene that need several keys.
#include "io/scene_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace io {

namespace {

/// Random placing without overlaps jams near a fraction of 0.38 in space; below this bound it is quick.
constexpr double largest_random_fraction = 0.32;

class SceneChecker {
public:
    SceneChecker(const Scene& scene, const Locations& locations, Problems& problems)
        : scene_(scene), locations_(locations), problems_(problems)
    {
    }

    void check()
    {
        if (!scene_.fluid && !locations_.given("particles"))
            complain("", "the scene has neither 'fluid' nor 'particles'", "add one of them");
        if (scene_.fluid) check_boundaries(scene_, locations_, problems_);
        if (scene_.fluid && scene_.fluid->drive) check_drive(*scene_.fluid->drive);
        for (std::size_t n = 0; n < scene_.particles.size(); ++n) check_species(n);
        check_company();
        if (scene_.coupling) check_filter(*scene_.coupling);
        if (scene_.run.time_step && all_good({"run.time_step", "run.until"}) && *scene_.run.time_step > scene_.run.until)
            complain("run.time_step", "the time step is longer than the run", "make it shorter than run.until");
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

    void check_drive(const Drive& drive)
    {
        const std::string path = "fluid.drive";
        const int axis = drive.axis == Axis::axial ? 0 : static_cast<int>(drive.axis) - 1;
        if (all_good({path + ".axis", "grid.periodic"}) && !scene_.grid.is_periodic(axis))
            complain(locations_.given(path + ".axis") ? path + ".axis" : path,
                     fmt::format("the drive acts along {}, which is not periodic", axis_words[std::size_t(axis) + 1]),
                     "add the axis to grid.periodic");
        if (drive.frequency && drive.reverse_at) complain(path + ".reverse_at", "'reverse_at' excludes 'frequency'", "keep one of the two");
        if (drive.over_time) check_drive_over_time(drive);
        if (drive.reverse_at && !drive.pressure_gradient && all_good({path}))
            complain(path + ".reverse_at", "'reverse_at' needs 'pressure_gradient'", "remove it, or give the gradient");
        if (drive.flow_rate || drive.bulk_velocity) check_prescribed_flow(path);
        if (drive.reverse_at && locations_.good(path + ".pressure_gradient") && drive.pressure_gradient == 0.0)
            complain(path + ".pressure_gradient", "without a gradient the flow never reverses", "write a gradient other than 0");
        if (drive.reverse_at && !scene_.grid.pipe && locations_.good("grid"))
            complain(path + ".reverse_at", fmt::format("'reverse_at' watches the axis of a pipe, and this is a {}", scene_.grid.shape()),
                     "use 'frequency', or grid.pipe");
    }

    void check_drive_over_time(const Drive& drive)
    {
        const std::string path = "fluid.drive.over_time";
        if (drive.frequency)
            complain(path, "'over_time' excludes 'frequency'", "keep one of the two; over_time has a frequency of its own");
        if (drive.reverse_at) complain(path, "'over_time' excludes 'reverse_at'", "keep one of the two");
        if (locations_.good("run.until")) check_course(*drive.over_time, path, scene_.run.until, locations_, problems_);
    }

    /// The same must flow through all sections.
    void check_prescribed_flow(const std::string& path)
    {
        for (const Boundary& boundary : scene_.fluid->boundaries)
            if (boundary.kind == BoundaryKind::inflow || physics::gives_pressure(boundary.kind))
                complain(path, fmt::format("a flow cannot be prescribed where fluid also goes through '{}'", boundary.at),
                         "give a pressure_gradient, or make that boundary a wall");
    }

    [[nodiscard]] core::Vec3 low_of(const Species& species) const
    {
        return species.initial.low.value_or(margin(species, scene_.grid.low(), 0.5));
    }
    [[nodiscard]] core::Vec3 high_of(const Species& species) const
    {
        return species.initial.high.value_or(margin(species, scene_.grid.high(), -0.5));
    }
    /// A corner of the domain moved by a share of the diameter along the axes that have walls.
    [[nodiscard]] core::Vec3 margin(const Species& species, core::Vec3 corner, double share) const
    {
        for (int axis = 0; axis < 3; ++axis)
            if (!scene_.grid.is_periodic(axis)) corner[axis] += share * species.diameter;
        return corner;
    }

    void check_species(std::size_t n)
    {
        const Species& species = scene_.particles[n];
        const std::string path = fmt::format("particles.{}", n);
        for (std::size_t m = 0; m < n; ++m)
            if (all_good({path + ".name"}) && scene_.particles[m].name == species.name)
                complain(path + ".name", fmt::format("two species are named '{}'", species.name), "give each its own name");
        if (!all_good({"grid", path + ".diameter", path + ".initial"})) return;
        const core::Vec3 domain = scene_.grid.high() - scene_.grid.low();
        if (species.diameter >= domain.minCoeff())
            return complain(path + ".diameter", "the particles are larger than the domain",
                            fmt::format("the domain is {} m wide", number_text(domain.minCoeff())));
        if (check_region(species, path) && all_good({path + ".count", "particles"})) check_fraction(n, path);
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
                other.initial.low == species.initial.low && other.initial.high == species.initial.high)
                volume += other.count * std::numbers::pi / 6.0 * std::pow(other.diameter, 3);
        const double fraction = volume / room_of(species);
        if (fraction > largest_random_fraction)
            complain(path + ".count", fmt::format("the particles would fill {:.0f} % of their region", 100.0 * fraction),
                     fmt::format("random placing needs less than {:.0f} %: take fewer, a larger region, or "
                                 "arrangement: lattice",
                                 100.0 * largest_random_fraction));
    }

    /// Keys that need others, and keys that would do nothing.
    void check_company()
    {
        const bool particles = !scene_.particles.empty() || locations_.given("particles");
        if (particles && locations_.good("grid") && !scene_.grid.is_primitive())
            complain("particles", fmt::format("particles cannot be placed in grid.{} yet", scene_.grid.shape()),
                     "use grid.pipe or grid.box");
        if (particles && !scene_.contact) complain("particles", "particles need 'contact'", "add contact: { stiffness: 5 kN/m }");
        if (!particles && scene_.contact) complain("contact", "'contact' does nothing without 'particles'", "remove it, or add particles");
        if (particles && scene_.fluid && scene_.fluid->advection == AdvectionScheme::finite_volume)
            complain("fluid.advection", "finite volumes do not carry the momentum of a fluid between particles yet",
                     "write advection: lcsi, or leave it out");
        if (scene_.coupling && (!particles || !scene_.fluid))
            complain("coupling", "'coupling' needs both 'fluid' and 'particles'", "remove it, or add what is missing");
    }

    void check_filter(const Coupling& coupling)
    {
        if (!all_good({"coupling.filter", "grid", "particles"})) return;
        double width = coupling.filter.value;
        double largest = 0.0;
        for (const auto& species : scene_.particles) largest = std::max(largest, species.diameter);
        if (coupling.filter.in_diameters) width *= largest;
        const core::Vec3 domain = scene_.grid.high() - scene_.grid.low();
        if (width > 0.5 * domain.minCoeff())
            complain("coupling.filter", fmt::format("a filter of {} m is wider than half of the domain", number_text(width)),
                     fmt::format("the domain is {} m wide", number_text(domain.minCoeff())));
    }

    const Scene& scene_;
    const Locations& locations_;
    Problems& problems_;
};

} // namespace

void check_scene(const Scene& scene, const Locations& locations, Problems& problems) { SceneChecker(scene, locations, problems).check(); }

} // namespace io

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of what a scene says of its boundaries.
#include "core/base/error.hpp"
#include "io/build/boundary_sides.hpp"
#include "io/scene/scene_reader.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace io {
namespace {

/// Keys that a kind of boundary has no use for, and one that it needs.
void check_keys(const Boundary& boundary, const std::string& path, const Locations& locations, Problems& problems)
{
    const auto kind = boundary_kind_words[std::size_t(boundary.kind)];
    const bool with_velocity = boundary.kind == BoundaryKind::wall || boundary.kind == BoundaryKind::inflow;
    const bool inflow = boundary.kind == BoundaryKind::inflow, by_points = !boundary.profile_file.empty();
    if (inflow && !by_points && !locations.given(path + ".velocity"))
        problems.add(locations.at(path), "an inflow needs 'velocity'", "add velocity: [0.1 m/s, 0 m/s, 0 m/s]");
    if (by_points && (boundary.velocity || boundary.profile))
        problems.add(locations.at(path + ".profile_file"), "'profile_file' excludes 'velocity' and 'profile'", "keep one of them");
    for (const auto& [key, given] : {std::pair{"profile", boundary.profile.has_value()}, {"profile_file", by_points}})
        if (given && !inflow)
            problems.add(locations.at(path + "." + key), fmt::format("'{}' means nothing for kind: {}", key, kind),
                         "remove it, or write kind: inflow");
    if (boundary.over_time && !with_velocity)
        problems.add(locations.at(path + ".over_time"), fmt::format("'over_time' means nothing for kind: {}", kind), "remove it");
    if (boundary.velocity && !with_velocity)
        problems.add(locations.at(path + ".velocity"), fmt::format("'velocity' means nothing for kind: {}", kind), "remove it");
    if (boundary.spin && boundary.kind != BoundaryKind::wall)
        problems.add(locations.at(path + ".spin"), fmt::format("'spin' means nothing for kind: {}", kind),
                     "remove it, or write kind: wall");
    if (boundary.spin && boundary.velocity) problems.add(locations.at(path + ".spin"), "'spin' excludes 'velocity'", "keep one of the two");
    if (boundary.pressure && !physics::gives_pressure(boundary.kind))
        problems.add(locations.at(path + ".pressure"), fmt::format("'pressure' means nothing for kind: {}", kind),
                     "remove it, or write kind: outflow or kind: pressure");
}

/// A name that the grid does not have.
void complain_of_name(const std::string& at, const std::vector<std::string>& names, const Grid& grid, const Mark& mark, Problems& problems)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto letter = axis_words[std::size_t(axis) + 1];
        if (grid.is_periodic(axis) && (at == fmt::format("{}_low", letter) || at == fmt::format("{}_high", letter)))
            return problems.add(mark, fmt::format("the grid repeats along {}: it has no boundary '{}'", letter, at),
                                fmt::format("remove it, or take {} out of grid.periodic", letter));
    }
    problems.add(mark, fmt::format("the grid has no boundary '{}'", at),
                 names.empty() ? "it repeats along all its axes" : suggestion(at, names));
}

/// Velocities that go through walls, or not through an inflow; and inflows whose fluid cannot go anywhere.
void check_fluxes(const Scene& scene, const BoundarySides& sides, const Locations& locations, Problems& problems)
{
    constexpr double slight = 1e-3;    // sine of an angle; grids in single precision have no less on faces of a ten-thousandth
    constexpr double round_off = 1e-9; // of what flows in and out, as before the first step
    double net = 0, magnitudes = 0;
    std::string first_inflow;
    bool known = true;
    for (std::size_t n = 0; n < scene.fluid->boundaries.size(); ++n) {
        const Boundary& boundary = scene.fluid->boundaries[n];
        const std::string path = fmt::format("fluid.boundaries.{}", n);
        known =
            known && !physics::gives_pressure(boundary.kind) && !boundary.profile && boundary.profile_file.empty() && !boundary.over_time;
        const bool flows = boundary.velocity && !boundary.velocity->isZero();
        if (!(flows || boundary.spin) || !locations.good(path)) continue;
        const FlowThrough flow = sides.flow_through(
            boundary.at, [&](const core::Vec3& x) { return boundary.spin ? boundary.spin->velocity(x) : *boundary.velocity; });
        if (boundary.kind == BoundaryKind::wall && flow.steepest > slight)
            problems.add(locations.at(path + (boundary.spin ? ".spin" : ".velocity")),
                         fmt::format("the wall '{}' would move through the fluid at {}", boundary.at, flow.face),
                         "a wall moves along itself; write kind: inflow where fluid goes through");
        if (boundary.kind == BoundaryKind::inflow && flow.magnitudes <= slight * flow.area * boundary.velocity->norm())
            problems.add(locations.at(path + ".velocity"),
                         fmt::format("nothing flows in through '{}': the velocity lies along it", boundary.at),
                         "turn the velocity, or write kind: wall");
        net += flow.net;
        magnitudes += flow.magnitudes;
        if (boundary.kind == BoundaryKind::inflow && first_inflow.empty()) first_inflow = path + ".kind";
    }
    if (known && !first_inflow.empty() && std::abs(net) > round_off * magnitudes)
        problems.add(locations.at(first_inflow),
                     fmt::format("{:.4g} m3/s more flow {} the domain than the other way, and no boundary gives way", std::abs(net),
                                 net > 0 ? "out of" : "into"),
                     "write kind: outflow for one of the other boundaries");
}

void check_scalars(const Scene& scene, const std::vector<std::string>& names, const Locations& locations, Problems& problems)
{
    constexpr std::array<std::string_view, 7> taken{"velocity",       "pressure", "velocity before", "volume flux",
                                                    "fluid fraction", "k",        "epsilon"};
    const auto& all = scene.fluid->scalars;
    for (std::size_t n = 0; n < all.size(); ++n) {
        const std::string path = fmt::format("fluid.scalars.{}", n);
        if (std::any_of(all.begin(), all.begin() + std::ptrdiff_t(n), [&](const Scalar& s) { return s.name == all[n].name; }) ||
            std::find(taken.begin(), taken.end(), all[n].name) != taken.end())
            problems.add(locations.at(path + ".name"), fmt::format("the name '{}' is taken", all[n].name),
                         "give each scalar a name of its own");
        for (std::size_t m = 0; m < all[n].entering.size(); ++m)
            if (const auto& at = all[n].entering[m].at; std::find(names.begin(), names.end(), at) == names.end())
                complain_of_name(at, names, scene.grid, locations.at(fmt::format("{}.entering.{}.at", path, m)), problems);
    }
}

void check_turbulence(const Scene& scene, const Locations& locations, Problems& problems)
{
    const TurbulenceKeys& keys = *scene.fluid->turbulence;
    const auto& all = scene.fluid->boundaries;
    const bool inflow = std::any_of(all.begin(), all.end(), [](const Boundary& b) { return b.kind == BoundaryKind::inflow; });
    if (!keys.speed && !inflow)
        problems.add(locations.at("fluid.turbulence"), "turbulence needs 'speed' where nothing flows in",
                     "add the speed of the flow, such as speed: 1 m/s");
    if (keys.roughness > 0 && keys.model == TurbulenceModel::abe_kondoh_nagano)
        problems.add(locations.at("fluid.turbulence.roughness"), "walls that are resolved are smooth",
                     "remove it, or let the model be k-epsilon");
    if (scene.fluid->material.viscosity == 0)
        problems.add(locations.at("fluid.turbulence"), "turbulence needs a fluid with viscosity", "give the viscosity, or remove it");
}

void check_boundary(const Scene& scene, std::size_t n, const std::vector<std::string>& names, const Locations& locations,
                    Problems& problems)
{
    const auto& all = scene.fluid->boundaries;
    const std::string path = fmt::format("fluid.boundaries.{}", n);
    if (!locations.good(path + ".at") || !locations.good(path + ".kind")) return;
    if (std::find(names.begin(), names.end(), all[n].at) == names.end())
        complain_of_name(all[n].at, names, scene.grid, locations.at(path + ".at"), problems);
    if (std::any_of(all.begin(), all.begin() + std::ptrdiff_t(n), [&](const Boundary& b) { return b.at == all[n].at; }))
        problems.add(locations.at(path + ".at"), fmt::format("'{}' is given twice", all[n].at), "keep one of the two");
    check_keys(all[n], path, locations, problems);
    if (all[n].over_time && locations.good("run.until"))
        check_course(*all[n].over_time, path + ".over_time", scene.run.until, locations, problems);
}

} // namespace

void check_boundaries(const Scene& scene, const Locations& locations, Problems& problems)
{
    if (scene.fluid->is_turbulent()) check_turbulence(scene, locations, problems);
    const auto& all = scene.fluid->boundaries;
    if ((all.empty() && scene.fluid->scalars.empty()) || !locations.good("grid") || !locations.good("grid.periodic")) return;
    try {
        const BoundarySides sides(scene.grid);
        const std::vector<std::string> names = sides.names();
        check_scalars(scene, names, locations, problems);
        const std::size_t before = problems.size();
        for (std::size_t n = 0; n < all.size(); ++n) check_boundary(scene, n, names, locations, problems);
        if (problems.size() == before && locations.good("fluid.boundaries")) check_fluxes(scene, sides, locations, problems);
    } catch (const core::ConfigError& error) { // sides that cannot be matched
        problems.add(locations.at("grid"), error.what(), "");
    }
}

void check_contact_sides(const Scene& scene, const Locations& locations, Problems& problems)
{
    const auto& all = scene.contact->sides;
    if (all.empty() || !locations.good("grid") || !locations.good("grid.periodic")) return;
    if (scene.contact->walls == WallShape::none)
        return problems.add(locations.at("contact.sides"), "'sides' mean nothing for walls: none", "remove them, or write walls: faces");
    try {
        const std::vector<std::string> names = BoundarySides(scene.grid).names();
        for (std::size_t n = 0; n < all.size(); ++n) {
            const std::string path = fmt::format("contact.sides.{}.at", n);
            if (!locations.good(path)) continue;
            if (std::find(names.begin(), names.end(), all[n].at) == names.end())
                complain_of_name(all[n].at, names, scene.grid, locations.at(path), problems);
            if (std::any_of(all.begin(), all.begin() + std::ptrdiff_t(n), [&](const ContactSide& s) { return s.at == all[n].at; }))
                problems.add(locations.at(path), fmt::format("the material of '{}' is given twice", all[n].at), "keep one of the two");
        }
    } catch (const core::ConfigError& error) { // sides that cannot be matched
        problems.add(locations.at("grid"), error.what(), "");
    }
}

} // namespace io

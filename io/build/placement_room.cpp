// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/placement_room.hpp"
#include "core/grid/extents.hpp"
#include "io/build/grain_census.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

bool is_inside(const Grid& grid, const core::Vec3& x)
{
    if (grid.pipe && std::hypot(x.y(), x.z()) > 0.5 * grid.pipe->diameter) return false;
    const core::Vec3 low = grid.low(), high = grid.high();
    for (int a = 0; a < 3; ++a)
        if (!grid.is_periodic(a) && (x[a] < low[a] || x[a] > high[a])) return false;
    return true;
}

/// A box around a round region.
physics::BoxRegion box_around(const physics::Region& region)
{
    if (const auto* sphere = std::get_if<physics::SphereRegion>(&region))
        return {sphere->centre - core::Vec3::Constant(sphere->radius), sphere->centre + core::Vec3::Constant(sphere->radius)};
    const auto& c = std::get<physics::CylinderRegion>(region);
    const core::Vec3 reach = core::Vec3::Constant(c.radius);
    return {c.from.cwiseMin(c.to) - reach, c.from.cwiseMax(c.to) + reach};
}

double volume_inside(const Grid& grid, const physics::Region& region)
{
    constexpr int points = 100; // along each axis
    const physics::BoxRegion box = box_around(region);
    const core::Vec3 step = (box.high - box.low) / points;
    std::int64_t all = 0, inside = 0;
    core::for_each({0, 0, 0}, {points, points, points}, [&](int i, int j, int k) {
        const core::Vec3 x = box.low + step.cwiseProduct(core::Vec3(i + 0.5, j + 0.5, k + 0.5));
        if (!physics::contains(region, x)) return;
        ++all;
        if (is_inside(grid, x)) ++inside;
    });
    return physics::volume_of(region) * double(inside) / double(std::max<std::int64_t>(all, 1));
}

} // namespace

core::Vec3 moved_corner(const Scene& scene, const Species& species, core::Vec3 corner, double share)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!scene.grid.is_periodic(axis)) corner[axis] += share * size_range(species)[1];
    return corner;
}

core::Vec3 low_of(const Scene& scene, const Species& species)
{
    return species.initial.region.low.value_or(moved_corner(scene, species, scene.grid.low(), 0.5));
}

core::Vec3 high_of(const Scene& scene, const Species& species)
{
    return species.initial.region.high.value_or(moved_corner(scene, species, scene.grid.high(), -0.5));
}

double room_of(const Scene& scene, const Species& species)
{
    if (species.initial.region.is_round()) {
        const physics::Region centres = species.initial.region.region({});
        return volume_inside(scene.grid, physics::grown(centres, 0.5 * size_range(species)[1]));
    }
    const core::Vec3 reach = core::Vec3::Constant(size_range(species)[1]);
    const core::Vec3 room = high_of(scene, species) - low_of(scene, species) + reach;
    return std::min(room.cwiseMin(scene.grid.high() - scene.grid.low()).prod(), scene.grid.volume());
}

int filling_count(const Scene& scene, const Species& species)
{
    const double each = std::numbers::pi / 6 * mean_cube(species);
    return int(std::min(2e9, std::round(*species.volume_fraction * room_of(scene, species) / each)));
}

} // namespace io

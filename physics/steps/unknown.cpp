// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/unknown.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/gradient.hpp"

namespace physics {
Unknown::Unknown(const SystemContext& context, const BlockLayout& layout, const std::string& name)
    : value({name, "", 1, false}, context.mesh.own_cells()), gradient({"gradient of " + name, "", 1, false}, context.mesh.own_cells()),
      flux({"flux of " + name, "", 0, false}, context.mesh.own_cells()), context_(context), layout_(layout)
{
    value.allocate();
    gradient.allocate();
    flux.allocate();
    context_.halos.prepare(&value, 1);
    context_.halos.prepare(&gradient, 1);
}

tasks::Job Unknown::form_fluxes(tasks::Lane& lane, BehindWalls walls, std::span<const double> in)
{
    const bool given = walls == BehindWalls::value;
    const double beyond_wall = given ? -1 : 1;
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(value.on(b), [](double x) { return x; }, core::View<const double>(in.data() + layout_.origin(b), layout_.cells(b), 0));
    });
    co_await context_.halos.fill(lane, &value, 1);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const auto q = value.on(b);
        for_each_mirrored(context_.walls[std::size_t(b)], q.extents(), 1,
                          [&](core::Side, core::Index3 inside, core::Index3 beyond) { q[beyond] = beyond_wall * q[inside]; });
        physics::gradient(geometry, given ? geometry.wall_gradient : geometry.gradient, q, gradient.on(b));
    });
    co_await context_.halos.fill(lane, &gradient, 1);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto& block_walls = context_.walls[std::size_t(b)];
        gradient_flux(context_.mesh.geometry(b), value.on(b), gradient.on(b), flux.on(b));
        if (given) wall_gradient_flux(context_.mesh.geometry(b), block_walls, value.on(b), flux.on(b));
        else close_walls(block_walls, flux.on(b));
    });
}

} // namespace physics

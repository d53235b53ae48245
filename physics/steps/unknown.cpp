// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/steps/unknown.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/wall_profile.hpp"

#include <utility>

namespace physics {
Unknown::Unknown(const SystemContext& context, const BlockLayout& layout, const std::string& name)
    : value({name, "", 1, false}, context.mesh.own_cells()),
      gradient({"gradient of " + name, "", 1, false}, context.mesh.own_cells()),
      flux({"flux of " + name, "", 0, false}, context.mesh.own_cells()),
      context_(context),
      layout_(layout)
{
    value.allocate();
    flux.allocate();
    context_.halos.prepare(&value, core::beside);
    if (context_.is_straight) return; // nothing reads the gradient
    gradient.allocate();
    context_.halos.prepare(&gradient, core::beside);
}

tasks::Job Unknown::form_fluxes(tasks::Lane& lane, std::optional<int> component, std::span<const double> in)
{
    for_blocks(lane, [&](core::LocalBlock b) {
        map_cells(
            value.on(b), [](double x) { return x; }, core::View<const double>(in.data() + layout_.origin(b), layout_.cells(b), 0));
    });
    co_await context_.halos.fill(lane, &value, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const auto& walls = context_.walls[std::size_t(b)];
        if (component) mirror_velocity_change(walls, *component, value.on(b));
        else mirror_pressure_change(walls, 1, value.on(b));
        if (context_.is_straight) return;
        if (component) velocity_gradient(geometry, walls, context_.viscosity_factors(b), value.on(b), gradient.on(b));
        else physics::gradient(geometry, pressure_matrices(geometry, walls), value.on(b), gradient.on(b));
    });
    if (!context_.is_straight) co_await context_.halos.fill(lane, &gradient, core::beside);
    for_blocks(lane, [&](core::LocalBlock b) {
        const auto& geometry = context_.mesh.geometry(b);
        const auto& walls = context_.walls[std::size_t(b)];
        const auto gradients = context_.is_straight ? core::VectorView<const double>{} : std::as_const(gradient).on(b);
        gradient_flux(geometry, value.on(b), gradients, flux.on(b));
        if (!component) return pressure_wall_flux(geometry, walls, value.on(b), flux.on(b));
        wall_gradient_flux(geometry, walls, value.on(b), flux.on(b));
        if (!context_.viscosity_factors(b)) add_bend(geometry, walls, value.on(b), flux.on(b));
    });
}

} // namespace physics

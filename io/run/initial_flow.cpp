// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/initial_flow.hpp"
#include "core/comm/halo.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/face_flux.hpp"

namespace io {

void start_from(World& world, const VelocityFunction& velocity)
{
    const core::Mesh& mesh = world.mesh();
    physics::FluidState& state = world.fluid()->state();
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const auto u = state.velocity.on(b);
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const core::Vec3 v = velocity(mesh.geometry(b).centre(i, j, k));
            u.x(i, j, k) = v.x();
            u.y(i, j, k) = v.y();
            u.z(i, j, k) = v.z();
        });
    }
    const core::HaloExchange exchange(mesh, world.ranks(), 3, 1, core::HaloShape::faces);
    exchange.fill(state.velocity);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const physics::BlockWalls& walls = world.fluid()->walls()[std::size_t(b)];
        physics::mirror_velocity(walls, 1, state.velocity.on(b));
        physics::interpolated_flux(mesh.geometry(b), walls, state.velocity.on(b), state.flux.on(b));
    }
    constexpr int steps_after_a_jump = 2; // see FluidClock
    state.clock.steps_since_jump = steps_after_a_jump;
}

} // namespace io

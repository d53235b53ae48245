// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/boundary.hpp"
#include "core/base/error.hpp"

namespace physics {

std::vector<BlockWalls> make_walls(const core::Mesh& mesh, const WallVelocities& velocities)
{
    std::vector<BlockWalls> walls(std::size_t(mesh.own_count()));
    WallVelocities unused = velocities;
    for (const core::Boundary& boundary : mesh.topology().boundaries) {
        const auto moving = velocities.find(boundary.name);
        unused.erase(boundary.name);
        const core::LocalBlock b = mesh.local(boundary.block);
        if (b < 0) continue;
        auto& block = walls[std::size_t(b)];
        block.is_wall[std::size_t(boundary.side)] = true;
        if (moving != velocities.end()) block.velocity[std::size_t(boundary.side)] = moving->second;
    }
    core::require<core::ConfigError>(unused.empty(), core::text("no boundary is called '",
                                                                unused.empty() ? "" : unused.begin()->first, "'"));
    return walls;
}

void mirror_even(const BlockWalls& walls, int layers, core::View<double> q)
{
    for_each_mirrored(walls, q.extents(), layers, [&](core::Side, core::Index3 inside, core::Index3 beyond) { q[beyond] = q[inside]; });
}

void mirror_component(const BlockWalls& walls, int component, int layers, core::View<double> velocity)
{
    for_each_mirrored(walls, velocity.extents(), layers, [&](core::Side side, core::Index3 inside, core::Index3 beyond) {
        velocity[beyond] = 2 * walls.velocity[std::size_t(side)][component] - velocity[inside];
    });
}

void mirror_velocity(const BlockWalls& walls, int layers, core::VectorView<double> velocity)
{
    for (int c = 0; c < 3; ++c) mirror_component(walls, c, layers, velocity.component(c));
}

void mirror_source(const BlockWalls& walls, int layers, core::VectorView<const double> velocity, core::VectorView<double> q)
{
    for (int c = 0; c < 3; ++c) {
        const auto from = velocity.component(c);
        const auto to = q.component(c);
        for_each_mirrored(walls, to.extents(), layers, [&](core::Side, core::Index3 inside, core::Index3 beyond) {
            to[beyond] = from[beyond] + (to[inside] - from[inside]);
        });
    }
}

} // namespace physics

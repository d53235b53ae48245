// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What holds at the walls of a block: halo values that make the stencils inside see the wall.
#include "core/grid/mesh.hpp"
#include <map>
#include <string>

namespace physics {

/// Velocity of the walls by boundary name [m/s]; walls that are not named stand still.
using WallVelocities = std::map<std::string, core::Vec3>;

/// The sides of one block that are walls, and how these move.
struct BlockWalls {
    std::array<bool, 6> is_wall{};
    std::array<core::Vec3, 6> velocity{core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero(),
                                       core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero()};
};

/// One entry for each block of this rank.
/// @throws ConfigError for a name that no boundary has.
[[nodiscard]] std::vector<BlockWalls> make_walls(const core::Mesh& mesh, const WallVelocities& velocities);

/// Calls body(side, cell inside, cell beyond) for `layers` layers beyond every wall, the halo of the other directions
/// included. Axis by axis, layer by layer: so edges and corners get filled, and blocks thinner than their halo.
template <class Body>
void for_each_mirrored(const BlockWalls& walls, core::Extents cells, int layers, Body body)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int depth = 0; depth < layers; ++depth)
            for (const bool high : {false, true}) {
                const core::Side side = core::side_of(axis, high);
                if (!walls.is_wall[std::size_t(side)]) continue;
                core::Index3 first{-layers, -layers, -layers}, last{cells.ni + layers, cells.nj + layers, cells.nk + layers};
                first[axis] = high ? cells[axis] + depth : -1 - depth;
                last[axis] = first[axis] + 1;
                const int inside = high ? cells[axis] - 1 - depth : depth;
                core::for_each(first, last, [&](int i, int j, int k) {
                    core::Index3 from{i, j, k};
                    from[axis] = inside;
                    body(side, from, core::Index3{i, j, k});
                });
            }
}

/// Halo beyond walls: the value inside, so that nothing flows through the wall.
void mirror_even(const BlockWalls& walls, int layers, core::View<double> q);
/// Halo beyond walls: the wall has its own velocity, beyond it lies the mirror image.
void mirror_velocity(const BlockWalls& walls, int layers, core::VectorView<double> velocity);
/// One component of mirror_velocity().
void mirror_component(const BlockWalls& walls, int component, int layers, core::View<double> velocity);
/// Halo of q = velocity + increment beyond walls: velocity mirrored at the wall's, increment mirrored evenly.
void mirror_source(const BlockWalls& walls, int layers, core::VectorView<const double> velocity, core::VectorView<double> q);

} // namespace physics

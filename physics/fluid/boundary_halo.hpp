// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Halo values beyond boundaries that make the stencils inside see what holds there.
#include "physics/fluid/boundary.hpp"

namespace physics {

/// Calls body(side, cell inside, cell beyond) for `layers` layers beyond every boundary, the halo of the other directions
/// included. Axis by axis, layer by layer: so edges and corners get filled, and blocks thinner than their halo.
template <class Body>
void for_each_mirrored(const BlockWalls& walls, core::Extents cells, int layers, Body body)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int depth = 0; depth < layers; ++depth)
            for (const bool high : {false, true}) {
                const BlockSide& side = walls.at(core::side_of(axis, high));
                if (!side.kind) continue;
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

/// The velocity beyond a boundary that mirrors the one inside.
/// @param at  The cell inside, or the face.
[[nodiscard]] core::Vec3 mirrored(const BlockSide& side, core::Index3 at, const core::Vec3& inside);

/// The velocity that goes with the flux through a face of a boundary; what flows back through an outflow was at rest.
/// @param outward  Flux through the face [m3/s].
[[nodiscard]] core::Vec3 carried_through(const BlockSide& side, core::Index3 at, double outward, const core::Vec3& inside);

/// Beyond boundaries that give the velocity lies its mirror image about that; the velocity across slip walls is mirrored so, that
/// along them goes on as inside; where the pressure is given, all of it goes on.
void mirror_velocity(const BlockWalls& walls, int layers, core::VectorView<double> velocity);
/// One layer of a change of one component, in which boundaries have no part of their own.
void mirror_velocity_change(const BlockWalls& walls, int component, core::View<double> change);
/// The same of all components, which slip walls join.
void mirror_velocity_change(const BlockWalls& walls, core::VectorView<double> change);
/// Halo of q = velocity + increment: velocity mirrored as above, the increment reflected by slip walls and even at others.
/// Behind an outflow lies fluid at rest where the flow turns back.
void mirror_source(const BlockWalls& walls, int layers, core::VectorView<const double> velocity, core::VectorView<double> q);

/// Beyond boundaries that give the pressure its mirror image about that, beyond others the pressure inside.
void mirror_pressure(const BlockWalls& walls, int layers, core::View<double> pressure);
/// The same of a change of pressure, which vanishes where the pressure is given.
void mirror_pressure_change(const BlockWalls& walls, int layers, core::View<double> change);
/// The value inside.
void mirror_even(const BlockWalls& walls, int layers, core::View<double> q);

} // namespace physics

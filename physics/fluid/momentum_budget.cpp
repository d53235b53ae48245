// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/momentum_budget.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/wall_profile.hpp"

namespace physics {
namespace {

/// Calls body(side, cell inside, index of the face along the axis of the side) for every face on a boundary.
template <class Body>
void for_each_wall_face(const core::BlockGeometry& geometry, const BlockWalls& walls, Body body)
{
    for (const core::Side side : core::all_sides)
        if (walls.at(side).kind)
            for_each_side_face(geometry.cells, side, [&](int i, int j, int k) {
                const core::Index3 face{i, j, k};
                body(side, cell_at_face(face, side), face);
            });
}

} // namespace

core::Vec3 volume_sum(const core::BlockGeometry& geometry, core::VectorView<const double> q)
{
    core::Vec3 sum;
    for (int c = 0; c < 3; ++c) sum[c] = sum_cells([](double v, double x) { return v * x; }, geometry.volume.view(), q.component(c));
    return sum;
}

core::Vec3 wall_friction(const core::BlockGeometry& geometry, const BlockWalls& walls, core::VectorView<const double> velocity,
                         const FaceFactors& factors)
{
    core::Vec3 sum = core::Vec3::Zero();
    for_each_wall_face(geometry, walls, [&](core::Side side, core::Index3 c, core::Index3 face) {
        const core::Vec3 u(velocity.x[c], velocity.y[c], velocity.z[c]);
        const double transmissibility = geometry.face[std::size_t(core::axis_of(side))].transmissibility.view()[face];
        const double factor = factors ? factors->along(core::axis_of(side))[face] : 1.0;
        sum += 0.5 * factor * transmissibility * (mirrored(walls.at(side), c, u) - u);
    });
    if (factors) return sum;
    for_each_wall_profile(geometry, walls, [&](core::Side side, const WallProfile& p) {
        const core::Index3 c = p.cell;
        const core::Vec3 u(velocity.x[c], velocity.y[c], velocity.z[c]), from_boundary = 0.5 * (u - mirrored(walls.at(side), c, u));
        for (int n = 0; n < 3; ++n) sum[n] += p.inflow(from_boundary[n], velocity.component(n)[p.inner] - u[n]);
    });
    return sum;
}

core::Vec3 wall_push(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> pressure, double share)
{
    core::Vec3 sum = core::Vec3::Zero();
    for_each_wall_face(geometry, walls, [&](core::Side side, core::Index3 c, core::Index3 face) {
        const core::Vec3 area = geometry.area(core::axis_of(side), face.i, face.j, face.k);
        const double at_wall = walls.at(side).gives_pressure() ? share * walls.at(side).pressure : pressure[c];
        sum += (core::is_high(side) ? -at_wall : at_wall) * area;
    });
    return sum;
}

core::Vec3 through_flow(const core::BlockGeometry& geometry, const BlockWalls& walls, core::FaceView<const double> flux,
                        core::VectorView<const double> velocity)
{
    core::Vec3 sum = core::Vec3::Zero();
    for_each_wall_face(geometry, walls, [&](core::Side side, core::Index3 c, core::Index3 face) {
        const core::Vec3 u(velocity.x[c], velocity.y[c], velocity.z[c]);
        const double through = flux.along(core::axis_of(side))[face];
        const double outward = core::is_high(side) ? through : -through;
        sum -= outward * carried_through(walls.at(side), c, outward, u);
    });
    return sum;
}

} // namespace physics

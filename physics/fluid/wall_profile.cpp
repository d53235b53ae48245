// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/wall_profile.hpp"
#include "physics/fluid/gradient.hpp"

#include <cmath>

namespace physics {
namespace {

core::Index3 stepped(core::Index3 at, core::Side side, int steps)
{
    at[core::axis_of(side)] += core::is_high(side) ? steps : -steps;
    return at;
}

/// q less its value on the boundary, half way to the mirror image.
double from_boundary(core::View<const double> q, core::Side side, core::Index3 cell) { return 0.5 * (q[cell] - q[stepped(cell, side, 1)]); }

core::Vec3 centre(const core::BlockGeometry& geometry, core::Index3 c) { return geometry.centre(c.i, c.j, c.k); }

bool lies_beside(const core::BlockGeometry& geometry, core::Side side, core::Index3 cell)
{
    const int axis = core::axis_of(side);
    return cell[axis] == (core::is_high(side) ? geometry.cells[axis] - 1 : 0);
}

/// Gradient that a profile adds to that of least squares, which leaves (1 - 2 d/D) of what it does not say of the slope a.
core::Vec3 gradient_by_bend(const core::BlockGeometry& geometry, core::Side side, core::Index3 cell, core::View<const double> q,
                            const core::Vec3& plain)
{
    const core::Index3 face = core::is_high(side) ? stepped(cell, side, 1) : cell;
    const core::Vec3 way = 0.5 * (centre(geometry, cell) - centre(geometry, stepped(cell, side, 1)));
    const core::Vec3 area = geometry.area(core::axis_of(side), face.i, face.j, face.k);
    const double gain = 1 - 2 * WallProfile(geometry, side, face).share;
    return gain * (from_boundary(q, side, cell) - plain.dot(way)) / area.dot(way) * area;
}

} // namespace

WallProfile::WallProfile(const core::BlockGeometry& geometry, core::Side side, core::Index3 at)
    : face(at), cell(cell_at_face(at, side)), inner(stepped(cell, side, -1))
{
    const int axis = core::axis_of(side);
    const core::Index3 inner_face = stepped(face, side, -1);
    const auto transmissibility = geometry.face[std::size_t(axis)].transmissibility.view();
    const auto square = [&](core::Index3 f) { return geometry.area(axis, f.i, f.j, f.k).squaredNorm(); };
    // A transmissibility is an area over the distance along its normal.
    const double areas = std::sqrt(square(face) / square(inner_face));
    share = areas * transmissibility[inner_face] / (areas * transmissibility[inner_face] + transmissibility[face]);
    own = share * transmissibility[face];
    next = share * transmissibility[inner_face] * areas;
}

bool has_profiles(const core::BlockGeometry& geometry, const BlockWalls& walls, core::Side side)
{
    return walls.at(side).gives_flux() && !walls.at(side).slips() && geometry.cells[core::axis_of(side)] > 1;
}

void add_bend(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q, core::View<double> inflow)
{
    for_each_wall_profile(geometry, walls, [&](core::Side side, const WallProfile& p) {
        inflow[p.cell] += p.inflow(from_boundary(q, side, p.cell), q[p.inner] - q[p.cell]);
    });
}

void add_bend(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q, core::FaceView<double> flux)
{
    for_each_wall_profile(geometry, walls, [&](core::Side side, const WallProfile& p) {
        const double inflow = p.inflow(from_boundary(q, side, p.cell), q[p.inner] - q[p.cell]);
        flux.along(core::axis_of(side))[p.face] += core::is_high(side) ? inflow : -inflow;
    });
}

void velocity_gradient(const core::BlockGeometry& geometry, const BlockWalls& walls, const FaceFactors& factors, core::View<const double> q,
                       core::VectorView<double> out)
{
    gradient(geometry, geometry.wall_gradient, q, out);
    if (factors) return;
    for (const core::Side first : core::all_sides) {
        if (!has_profiles(geometry, walls, first)) continue;
        for_each_side_face(geometry.cells, first, [&](int i, int j, int k) {
            const core::Index3 cell = cell_at_face({i, j, k}, first);
            const core::Vec3 plain(out.x[cell], out.y[cell], out.z[cell]);
            core::Vec3 all = plain; // in a corner all sides start from the same
            for (const core::Side side : core::all_sides) {
                if (!has_profiles(geometry, walls, side) || !lies_beside(geometry, side, cell)) continue;
                if (side < first) return; // done with that side
                all += gradient_by_bend(geometry, side, cell, q, plain);
            }
            out.x[cell] = all.x();
            out.y[cell] = all.y();
            out.z[cell] = all.z();
        });
    }
}

} // namespace physics

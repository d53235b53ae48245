// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/wall_cells.hpp"
#include "physics/fluid/side_faces.hpp"

namespace physics {

std::vector<WallCell> wall_cells(const core::BlockGeometry& geometry, const BlockWalls& walls)
{
    std::vector<WallCell> cells;
    core::Array3<int> count(geometry.cells);
    for (const core::Side side : core::all_sides) {
        if (walls.at(side).kind != BoundaryKind::wall) continue;
        const int axis = core::axis_of(side);
        for_each_side_face(geometry.cells, side, [&](int i, int j, int k) {
            const core::Index3 face{i, j, k}, cell = cell_at_face(face, side);
            const core::Vec3 area = geometry.area(axis, i, j, k);
            // The transmissibility is |S|^2 / (S . d), d from the centre to the wall.
            const double distance = area.norm() / geometry.face[std::size_t(axis)].transmissibility(i, j, k);
            cells.push_back({cell, face, side, distance, area.normalized(), 1.0});
            ++count(cell.i, cell.j, cell.k);
        });
    }
    for (WallCell& c : cells) c.share = 1.0 / count(c.cell.i, c.cell.j, c.cell.k);
    return cells;
}

double slip_speed(const BlockWalls& walls, const WallCell& at, core::VectorView<const double> velocity)
{
    const core::Vec3 u = core::Vec3(velocity.x[at.cell], velocity.y[at.cell], velocity.z[at.cell]) - walls.at(at.side).velocity[at.face];
    return (u - u.dot(at.normal) * at.normal).norm();
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/boundary_sides.hpp"
#include "core/base/error.hpp"
#include "core/grid/hexahedron.hpp"
#include "io/build/grid_builder.hpp"
#include "physics/fluid/side_faces.hpp"
#include <cmath>

namespace io {

BoundarySides::BoundarySides(const Grid& grid) : blocks_(make_blocks(grid)), topology_(core::match_sides(blocks_)) {}

std::vector<std::string> BoundarySides::names() const { return boundary_names(topology_); }

FlowThrough BoundarySides::flow_through(const std::string& name, const std::function<core::Vec3(const core::Vec3&)>& velocity) const
{
    FlowThrough all;
    for (const core::Boundary& boundary : topology_.boundaries) {
        if (boundary.name != name) continue;
        const core::Side side = boundary.side;
        const core::Vertices& vertices = blocks_.blocks[std::size_t(boundary.block)];
        physics::for_each_side_face(core::cells_of(vertices), side, [&](int i, int j, int k) {
            const core::FaceShape face = core::face_shape(core::face_corners(vertices, core::axis_of(side), {i, j, k}));
            const core::Vec3 v = velocity(face.centre);
            const double flux = face.area.dot(v), sine = std::abs(flux) / (face.area.norm() * v.norm());
            all.net += core::is_high(side) ? flux : -flux;
            all.magnitudes += std::abs(flux);
            all.area += face.area.norm();
            if (!(sine > all.steepest)) return;
            const core::Index3 cell = physics::cell_at_face({i, j, k}, side);
            all.steepest = sine;
            all.face = core::text("cell (", cell.i, ", ", cell.j, ", ", cell.k, ") at side ", core::side_words[std::size_t(side)],
                                  " of block ", boundary.block);
        });
    }
    return all;
}

} // namespace io

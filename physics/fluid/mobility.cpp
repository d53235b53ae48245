// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/mobility.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {

void face_mobility(const core::BlockGeometry& geometry, core::View<const double> mobility, core::FaceView<double> faces)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto out = faces.along(axis);
        const std::ptrdiff_t back = mobility.stride(axis);
        const core::Extents n = out.extents();
        for (int k = 0; k < n.nk; ++k)
            for (int j = 0; j < n.nj; ++j) {
                const double* m = mobility.row(j, k);
                double* f = out.row(j, k);
#pragma omp simd
                for (int i = 0; i < n.ni; ++i) f[i] = 2.0 * (m[i] * m[i - back]) / (m[i] + m[i - back]);
            }
    }
    combine_at_sub_faces(geometry, mobility, faces, [](double a, double b, double) { return 2.0 * (a * b) / (a + b); });
}

void scale_by_mobility(const core::BlockGeometry& geometry, core::FaceView<const double> mobility, core::FaceView<double> flux)
{
    map_faces(
        flux, [](double f, double m) { return f * m; }, flux, mobility);
    sum_sub_faces(geometry, flux);
}

void transmissibility(const core::BlockGeometry& geometry, core::FaceView<double> out)
{
    for (int axis = 0; axis < 3; ++axis)
        map_cells(
            out.along(axis), [](double t) { return t; }, geometry.face[std::size_t(axis)].transmissibility.view());
}

std::vector<LinkFace> link_faces(const core::Mesh& mesh, const MeshLinks& links)
{
    std::vector<LinkFace> faces;
    for (std::size_t n = 0; n < links.topology.links.size(); ++n) {
        const BlockLink& link = links.topology.links[n];
        const LinkEnd& end = mesh.local(link.a.block) >= 0 ? link.a : link.b;
        if (links.sub_face[n] >= 0) {
            faces.push_back({mesh.local(end.block), core::along_sub_faces, {links.sub_face[n], 0, 0}});
            continue;
        }
        const int axis = core::axis_of(end.side);
        core::Index3 face = cell_place(mesh.cells(end.block), end.cell);
        if (core::is_high(end.side)) ++face[axis];
        faces.push_back({mesh.local(end.block), axis, face});
    }
    return faces;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/mesh_links.hpp"
#include "core/grid/hexahedron.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"

namespace physics {
namespace {

core::Index3 stepped(core::Index3 c, int axis, int by)
{
    c[axis] += by;
    return c;
}

void add_interface(const core::Mesh& mesh, const core::Interface& f, MeshLinks& links)
{
    const int axis = core::axis_of(f.side_a);
    const core::Extents na = mesh.cells(f.a), nb = mesh.cells(f.b);
    for_each_side_face(na, f.side_a, [&](int i, int j, int k) {
        const core::Index3 face{i, j, k}, a = cell_at_face(face, f.side_a);
        const core::Index3 b = f.a_to_b(stepped(a, axis, core::is_high(f.side_a) ? 1 : -1));
        const core::FaceShape shape = core::face_shape(core::face_corners(mesh.vertices(f.a), axis, face));
        const core::Vec3 from = core::cell_shape(mesh.vertices(f.a), a).centroid;
        const core::Vec3 d = f.motion.origin_of(core::cell_shape(mesh.vertices(f.b), b).centroid) - from;
        links.topology.links.push_back({{f.a, cell_index(na, a.i, a.j, a.k), f.side_a}, {f.b, cell_index(nb, b.i, b.j, b.k), f.side_b}});
        const double along = std::abs(shape.area.dot(d));
        links.transmissibility.push_back(shape.area.squaredNorm() / along);
        links.spreading.push_back(along / d.squaredNorm());
        links.sub_face.push_back(-1);
    });
}

/// @param first  Number of the first sub-face.
void add_sub_faces(const core::Mesh& mesh, const core::SubFaceInterface& f, int first, MeshLinks& links)
{
    const core::SideContact& c = f.contact;
    const core::Extents na = mesh.cells(c.a), nb = mesh.cells(c.b);
    for (const core::JoinedSubFace& s : f.faces) {
        links.topology.links.push_back(
            {{c.a, cell_index(na, s.a.i, s.a.j, s.a.k), c.side_a}, {c.b, cell_index(nb, s.b.i, s.b.j, s.b.k), c.side_b}});
        links.transmissibility.push_back(s.transmissibility);
        links.spreading.push_back(s.area.squaredNorm() * s.transmissibility / (s.area - s.cross).squaredNorm());
        links.sub_face.push_back(first++);
    }
}

void add_wall(const core::Mesh& mesh, const core::Boundary& boundary, MeshLinks& links)
{
    const core::LocalBlock block = mesh.local(boundary.block);
    const int axis = core::axis_of(boundary.side);
    const auto transmissibility = mesh.geometry(block).face[std::size_t(axis)].transmissibility.view();
    const core::Extents n = mesh.cells(boundary.block);
    for_each_side_face(n, boundary.side, [&](int i, int j, int k) {
        const core::Index3 c = cell_at_face({i, j, k}, boundary.side);
        links.topology.links.push_back({{boundary.block, cell_index(n, c.i, c.j, c.k), boundary.side}, {wall_block, 0, boundary.side}});
        links.transmissibility.push_back(transmissibility(i, j, k));
        links.spreading.push_back(transmissibility(i, j, k));
        links.sub_face.push_back(-1);
    });
}

} // namespace

MeshLinks make_mesh_links(const core::Mesh& mesh, int rank, const std::function<bool(const core::Boundary&)>& gives_value)
{
    MeshLinks links;
    links.topology.cells = mesh.topology().cells;
    links.topology.owner = mesh.owners();
    links.topology.rank = rank;
    for (const core::Interface& f : mesh.topology().interfaces)
        if (mesh.owner(f.a) == rank || mesh.owner(f.b) == rank) add_interface(mesh, f, links);
    std::vector<int> count(std::size_t(mesh.blocks()), 0); // of sub-faces of each block so far
    for (const core::SubFaceInterface& f : mesh.topology().joints.interfaces) {
        const auto a = std::size_t(f.contact.a), b = std::size_t(f.contact.b);
        const int faces = int(f.faces.size()), first_of_a = count[a], first_of_b = count[b] + (a == b ? faces : 0);
        if (mesh.owner(f.contact.a) == rank) add_sub_faces(mesh, f, first_of_a, links);
        else if (mesh.owner(f.contact.b) == rank) add_sub_faces(mesh, f, first_of_b, links);
        count[a] += faces;
        count[b] += faces;
    }
    for (const core::Boundary& boundary : mesh.topology().boundaries)
        if (mesh.owner(boundary.block) == rank && gives_value(boundary)) add_wall(mesh, boundary, links);
    return links;
}

void spreading(const core::BlockGeometry& geometry, core::FaceView<double> out)
{
    for (int axis = 0; axis < 3; ++axis) {
        const core::FaceMetrics& f = geometry.face[std::size_t(axis)];
        map_cells(
            out.along(axis),
            [](double x, double y, double z, double t, double inverse_square) { return (x * x + y * y + z * z) / t * inverse_square; },
            f.area_x.view(), f.area_y.view(), f.area_z.view(), f.transmissibility.view(), f.inverse_square.view());
    }
}

} // namespace physics

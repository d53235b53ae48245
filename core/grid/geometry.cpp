// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/geometry.hpp"
#include "core/grid/gradient_matrices.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/mesh.hpp"
#include "core/grid/sub_face_values.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

namespace core {
namespace {

Index3 shifted(Index3 c, int axis, int by)
{
    c[axis] += by;
    return c;
}

void set_centre(BlockGeometry& g, Index3 c, const Vec3& x)
{
    g.centre_x(c.i, c.j, c.k) = x.x();
    g.centre_y(c.i, c.j, c.k) = x.y();
    g.centre_z(c.i, c.j, c.k) = x.z();
}

Vec3 centre(const BlockGeometry& g, Index3 c) { return g.centre(c.i, c.j, c.k); }

/// Centre of a boundary face, continued linearly to the halo of the tangential directions.
Vec3 boundary_face_centre(const Vertices& v, Side side, Index3 c, Extents n)
{
    const int axis = axis_of(side);
    const auto at = [&](Index3 cell) {
        cell[axis] = is_high(side) ? n[axis] : 0;
        return face_shape(face_corners(v, axis, cell)).centre;
    };
    Index3 inside = c;
    for (int m = 0; m < 3; ++m)
        if (m != axis) inside[m] = std::clamp(c[m], 0, n[m] - 1);
    Vec3 x = at(inside);
    for (int m = 0; m < 3; ++m) {
        if (m == axis || c[m] == inside[m] || n[m] < 2) continue;
        const int inward = c[m] < 0 ? 1 : -1;
        x += double(std::abs(c[m] - inside[m])) * (at(inside) - at(shifted(inside, m, inward)));
    }
    return x;
}

/// Beyond a boundary, centres are mirrored in its face, so that a mirrored field is smooth.
void mirror_centres(BlockGeometry& g, const Vertices& v, Side side)
{
    const int axis = axis_of(side), h = centre_halo;
    Index3 low{-h, -h, -h}, high{g.cells.ni + h, g.cells.nj + h, g.cells.nk + h};
    low[axis] = is_high(side) ? g.cells[axis] : -h;
    high[axis] = is_high(side) ? g.cells[axis] + h : 0;
    for_each(low, high, [&](int i, int j, int k) {
        const Index3 c{i, j, k};
        Index3 inside = c;
        inside[axis] = is_high(side) ? 2 * g.cells[axis] - 1 - c[axis] : -1 - c[axis];
        inside[axis] = std::clamp(inside[axis], -h, g.cells[axis] + h - 1);
        set_centre(g, c, 2 * boundary_face_centre(v, side, c, g.cells) - centre(g, inside));
    });
}

/// Volumes too, which come with the centres.
void fill_centres(BlockGeometry& g, const MultiBlock& grid, const Topology& topology, BlockId block)
{
    const Vertices& v = grid.blocks[std::size_t(block)];
    for (auto* array : {&g.centre_x, &g.centre_y, &g.centre_z}) *array = Array3<double>(g.cells, centre_halo, 0.0);
    g.volume = Array3<double>(g.cells, 0, 0.0);
    for_each_cell(g.cells, [&](int i, int j, int k) {
        const CellShape shape = cell_shape(v, {i, j, k});
        g.volume(i, j, k) = shape.volume;
        set_centre(g, {i, j, k}, shape.centroid);
    });
    for (const HaloRow& row : halo_rows(topology, block, centre_halo, HaloShape::full)) {
        Vec3 x = Vec3::Zero();
        for (const HaloSource& s : row.sources)
            x += s.weight * s.motion.origin_of(cell_shape(grid.blocks[std::size_t(s.block)], s.cell).centroid);
        set_centre(g, row.cell, x);
        if (!row.round_edge) continue;
        constexpr int reach = centre_halo;
        for_each({row.cell.i - reach, row.cell.j - reach, row.cell.k - reach},
                 {row.cell.i + reach + 1, row.cell.j + reach + 1, row.cell.k + reach + 1}, [&](int i, int j, int k) {
                     if (g.cells.contains({i, j, k})) g.near_singular(i, j, k) = 1;
                 });
    }
    for (Side s : all_sides)
        if (topology.at_boundary(block, s)) mirror_centres(g, v, s);
}

void fill_face(BlockGeometry& g, const Topology& topology, BlockId block, int axis, Index3 c, const FaceShape& shape)
{
    const bool low_boundary = c[axis] == 0 && topology.at_boundary(block, side_of(axis, false));
    const bool high_boundary = c[axis] == g.cells[axis] && topology.at_boundary(block, side_of(axis, true));
    const Vec3 from = low_boundary ? shape.centre : centre(g, shifted(c, axis, -1));
    const Vec3 to = high_boundary ? shape.centre : centre(g, c);
    const Vec3 d = to - from;
    const double across = shape.area.dot(d), t = shape.area.squaredNorm() / across;
    constexpr double rounding = 1e-12;
    const Vec3 rest = shape.area - t * d, cross = rest.norm() > rounding * shape.area.norm() ? rest : Vec3::Zero();
    const Vec3 apart = centre(g, c) - centre(g, shifted(c, axis, -1));
    FaceMetrics& f = g.face[std::size_t(axis)];
    f.inverse_square(c.i, c.j, c.k) = 1 / apart.squaredNorm();
    f.area_x(c.i, c.j, c.k) = shape.area.x();
    f.area_y(c.i, c.j, c.k) = shape.area.y();
    f.area_z(c.i, c.j, c.k) = shape.area.z();
    f.transmissibility(c.i, c.j, c.k) = t;
    f.cross_x(c.i, c.j, c.k) = cross.x();
    f.cross_y(c.i, c.j, c.k) = cross.y();
    f.cross_z(c.i, c.j, c.k) = cross.z();
    f.weight(c.i, c.j, c.k) = low_boundary ? 0.0 : high_boundary ? 1.0 : shape.area.dot(shape.centre - from) / across;
}

void fill_faces(BlockGeometry& g, const Topology& topology, const Vertices& v, BlockId block)
{
    for (int axis = 0; axis < 3; ++axis) {
        Extents n = g.cells;
        (axis == 0 ? n.ni : axis == 1 ? n.nj : n.nk) += 1;
        FaceMetrics& f = g.face[std::size_t(axis)];
        for (auto* array :
             {&f.area_x, &f.area_y, &f.area_z, &f.transmissibility, &f.cross_x, &f.cross_y, &f.cross_z, &f.inverse_square, &f.weight})
            *array = Array3<double>(n, 0, 0.0);
        for_each_cell(n, [&](int i, int j, int k) {
            const Index3 face{i, j, k};
            fill_face(g, topology, block, axis, face, face_shape(face_corners(v, axis, face)));
        });
    }
}

/// Faces beside an interface of sub-faces gain what its edges sweep by bending.
void bend_faces(BlockGeometry& g, const Topology& topology, const Vertices& v, BlockId block)
{
    std::map<std::array<int, 4>, Vec3> gains;
    for (const AreaChange& c : topology.joints.area_changes)
        if (c.block == block) gains.try_emplace({c.axis, c.face.k, c.face.j, c.face.i}, Vec3::Zero()).first->second += c.area;
    for (const auto& [at, gain] : gains) {
        const Index3 face{at[3], at[2], at[1]};
        const FaceShape straight = face_shape(face_corners(v, at[0], face));
        fill_face(g, topology, block, at[0], face, {straight.area + gain, straight.centre});
    }
}

/// Faces of joined sides become the sums of their sub-faces.
void add_sub_faces(BlockGeometry& g, const Topology& topology, const Vertices& v, BlockId block)
{
    std::map<std::array<int, 4>, std::pair<Vec3, double>> sums; // area and transmissibility
    std::map<std::array<int, 3>, std::size_t> numbers;          // of joined cells
    for (const BlockSubFace& s : sub_face_values(topology, block).faces) {
        Index3 face = s.cell;
        if (is_high(s.side)) ++face[axis_of(s.side)];
        const double sense = is_high(s.side) == s.is_a ? 1 : -1;
        g.sub_faces.push_back({axis_of(s.side), face, s.cell, s.beyond, s.at_centre, s.is_a, sense, s.face->area, s.face->transmissibility,
                               s.face->cross, s.face->from_a, s.face->from_b, s.face->weight});
        const auto [place, is_new] = numbers.try_emplace({s.cell.k, s.cell.j, s.cell.i}, g.joined_cells.size());
        if (is_new) g.joined_cells.push_back({s.cell, {}, {}});
        JoinedCell& cell = g.joined_cells[place->second];
        cell.joined[std::size_t(s.side)] = true;
        cell.sub_faces.push_back(int(g.sub_faces.size()) - 1);
        auto& sum = sums.try_emplace({axis_of(s.side), face.k, face.j, face.i}, Vec3::Zero(), 0.0).first->second;
        sum.first += sense * s.face->area;
        sum.second += s.face->transmissibility;
    }
    for (const auto& [at, sum] : sums) {
        const Index3 face{at[3], at[2], at[1]};
        fill_face(g, topology, block, at[0], face, {sum.first, face_shape(face_corners(v, at[0], face)).centre});
        g.face[std::size_t(at[0])].transmissibility.view()[face] = sum.second;
    }
}

void fill_inverse_jacobians(BlockGeometry& g)
{
    constexpr int h = centre_halo - 1;
    for (auto& row : g.inverse_jacobian)
        for (auto& array : row) array = Array3<double>(g.cells, h, 0.0);
    for_each({-h, -h, -h}, {g.cells.ni + h, g.cells.nj + h, g.cells.nk + h}, [&](int i, int j, int k) {
        const Index3 c{i, j, k};
        Mat3 jacobian;
        for (int m = 0; m < 3; ++m) jacobian.col(m) = 0.5 * (centre(g, shifted(c, m, 1)) - centre(g, shifted(c, m, -1)));
        const double scale = jacobian.col(0).norm() * jacobian.col(1).norm() * jacobian.col(2).norm();
        const bool regular = std::abs(jacobian.determinant()) > 1e-6 * scale;
        const Mat3 inverse = regular ? Mat3(jacobian.inverse()) : Mat3(Mat3::Zero());
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t n = 0; n < 3; ++n) g.inverse_jacobian[m][n](i, j, k) = inverse(int(m), int(n));
    });
}

} // namespace

BlockGeometry make_geometry(const MultiBlock& grid, const Topology& topology, BlockId block)
{
    const Vertices& v = grid.blocks[std::size_t(block)];
    BlockGeometry g;
    g.cells = topology.cells[std::size_t(block)];
    g.near_singular = Array3<unsigned char>(g.cells, 0, 0);
    fill_centres(g, grid, topology, block);
    fill_faces(g, topology, v, block);
    bend_faces(g, topology, v, block);
    add_sub_faces(g, topology, v, block);
    for (FaceMetrics& f : g.face)
        f.straight = std::ranges::all_of(std::array{&f.cross_x, &f.cross_y, &f.cross_z}, [](const auto* cross) {
            return std::ranges::all_of(cross->data(), [](double x) { return x == 0; });
        });
    std::array<bool, 6> inside{}, all;
    all.fill(true);
    for (const Side s : all_sides) inside[std::size_t(s)] = !topology.at_boundary(block, s);
    g.gradient = gradient_matrices(g, inside);
    g.wall_gradient = gradient_matrices(g, all);
    fill_inverse_jacobians(g);
    return g;
}

} // namespace core

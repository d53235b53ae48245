// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/face_flux.hpp"
#include "physics/fluid/faces_of_cells.hpp"
#include "physics/fluid/sub_face_flux.hpp"

#include <cmath>

namespace physics {
namespace {

/// T (q_high - q_low): all there is on straight faces.
void two_point_flux_along(const core::FaceMetrics& face, int axis, core::View<const double> q, core::View<double> flux)
{
    const core::Extents n = flux.extents();
    const std::ptrdiff_t back = q.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *t = face.transmissibility.view().row(j, k), *v = q.row(j, k);
            double* f = flux.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) f[i] = t[i] * (v[i] - v[i - back]);
        }
}

void gradient_flux_along(const core::FaceMetrics& face, int axis, core::View<const double> q, core::VectorView<const double> g,
                         core::View<double> flux)
{
    const core::Extents n = flux.extents();
    const std::ptrdiff_t back = q.stride(axis), gback = g.x.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *t = face.transmissibility.view().row(j, k), *cx = face.cross_x.view().row(j, k),
                         *cy = face.cross_y.view().row(j, k), *cz = face.cross_z.view().row(j, k);
            const double *v = q.row(j, k), *gx = g.x.row(j, k), *gy = g.y.row(j, k), *gz = g.z.row(j, k);
            double* f = flux.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i)
                f[i] = t[i] * (v[i] - v[i - back]) +
                       0.5 * (cx[i] * (gx[i] + gx[i - gback]) + cy[i] * (gy[i] + gy[i - gback]) + cz[i] * (gz[i] + gz[i - gback]));
        }
}

void interpolated_flux_along(const core::FaceMetrics& face, int axis, core::VectorView<const double> u, core::View<double> flux)
{
    const core::Extents n = flux.extents();
    const std::ptrdiff_t back = u.x.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *w = face.weight.view().row(j, k), *sx = face.area_x.view().row(j, k), *sy = face.area_y.view().row(j, k),
                         *sz = face.area_z.view().row(j, k);
            const double *x = u.x.row(j, k), *y = u.y.row(j, k), *z = u.z.row(j, k);
            double* f = flux.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const double b = w[i], a = 1 - b;
                f[i] = sx[i] * (b * x[i] + a * x[i - back]) + sy[i] * (b * y[i] + a * y[i - back]) + sz[i] * (b * z[i] + a * z[i - back]);
            }
        }
}

/// T (q_boundary - q) on the faces of a side, q_boundary half way to the mirror image.
void side_gradient_flux(const core::BlockGeometry& geometry, core::Side side, core::View<const double> q, core::FaceView<double> flux)
{
    const int axis = core::axis_of(side);
    const std::ptrdiff_t back = q.stride(axis);
    const auto f = flux.along(axis);
    const auto t = geometry.face[std::size_t(axis)].transmissibility.view();
    for_each_side_face(geometry.cells, side, [&](int i, int j, int k) {
        const std::ptrdiff_t c = q.offset(i, j, k);
        f(i, j, k) = t(i, j, k) * 0.5 * (q.at(c) - q.at(c - back));
    });
}

template <class IsClosed>
void close_sides(core::FaceView<double> flux, IsClosed is_closed)
{
    const core::Extents cells{flux.j.extents().ni, flux.i.extents().nj, flux.i.extents().nk};
    for (const core::Side side : core::all_sides) {
        if (!is_closed(side)) continue;
        const auto f = flux.along(core::axis_of(side));
        for_each_side_face(cells, side, [&](int i, int j, int k) { f(i, j, k) = 0; });
    }
}

} // namespace

void gradient_flux(const core::BlockGeometry& geometry, core::View<const double> q, core::VectorView<const double> gradients,
                   core::FaceView<double> flux)
{
    for (int axis = 0; axis < 3; ++axis) {
        const core::FaceMetrics& face = geometry.face[std::size_t(axis)];
        if (face.straight) two_point_flux_along(face, axis, q, flux.along(axis));
        else gradient_flux_along(face, axis, q, gradients, flux.along(axis));
    }
    sub_face_gradient_flux(geometry, q, gradients, flux);
}

void close_walls(const BlockWalls& walls, core::FaceView<double> flux)
{
    close_sides(flux, [&](core::Side side) { return walls.at(side).gives_flux(); });
}

void close_boundaries(const BlockWalls& walls, core::FaceView<double> flux)
{
    close_sides(flux, [&](core::Side side) { return walls.at(side).kind.has_value(); });
}

void wall_gradient_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q,
                        core::FaceView<double> flux)
{
    for (const core::Side side : core::all_sides)
        if (walls.at(side).kind) side_gradient_flux(geometry, side, q, flux);
}

void pressure_wall_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> pressure,
                        core::FaceView<double> flux)
{
    close_walls(walls, flux);
    for (const core::Side side : core::all_sides)
        if (walls.at(side).gives_pressure()) side_gradient_flux(geometry, side, pressure, flux);
}

void interpolated_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::VectorView<const double> u,
                       core::FaceView<double> flux)
{
    for (int axis = 0; axis < 3; ++axis) interpolated_flux_along(geometry.face[std::size_t(axis)], axis, u, flux.along(axis));
    sub_face_interpolated_flux(geometry, u, flux);
    wall_flux(geometry, walls, flux);
}

void wall_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::FaceView<double> flux)
{
    for (const core::Side side : core::all_sides) {
        if (!walls.at(side).gives_flux()) continue;
        const int axis = core::axis_of(side);
        const auto f = flux.along(axis);
        const SideVectors& velocity = walls.at(side).velocity;
        for_each_side_face(geometry.cells, side, [&](int i, int j, int k) {
            f(i, j, k) = geometry.area(axis, i, j, k).dot(velocity[{i, j, k}]);
        });
    }
}

void net_outflow(core::FaceView<const double> flux, core::View<double> outflow)
{
    map_faces_of_cells(outflow, flux, [](double low_i, double high_i, double low_j, double high_j, double low_k, double high_k) {
        return (high_i - low_i) + (high_j - low_j) + (high_k - low_k);
    });
}

void throughput(core::FaceView<const double> flux, core::View<double> through)
{
    const auto both = [](double low, double high) { return std::abs(high) + std::abs(low); };
    map_faces_of_cells(through, flux, [both](double low_i, double high_i, double low_j, double high_j, double low_k, double high_k) {
        return 0.5 * (both(low_i, high_i) + both(low_j, high_j) + both(low_k, high_k));
    });
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/transposed_stress.hpp"
#include "physics/fluid/side_faces.hpp"
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {
namespace {

/// (ratio - 1) (S . d u / d x_c - S_c div u) through the faces across an axis.
void flux_along(const TransposedStress& stress, int axis, int c, core::View<double> flux)
{
    const core::FaceMetrics& face = stress.geometry.face[std::size_t(axis)];
    const core::Extents n = flux.extents();
    const auto gx = stress.gradients[0].component(c), gy = stress.gradients[1].component(c), gz = stress.gradients[2].component(c);
    const auto dx = stress.gradients[0].x, dy = stress.gradients[1].y, dz = stress.gradients[2].z;
    const std::ptrdiff_t back = gx.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *sx = face.area_x.view().row(j, k), *sy = face.area_y.view().row(j, k), *sz = face.area_z.view().row(j, k);
            const double *w = face.weight.view().row(j, k), *r = stress.ratio.along(axis).row(j, k);
            const double *x = gx.row(j, k), *y = gy.row(j, k), *z = gz.row(j, k), *px = dx.row(j, k), *py = dy.row(j, k),
                         *pz = dz.row(j, k);
            const double* along = c == 0 ? sx : c == 1 ? sy : sz;
            double* f = flux.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const double b = w[i], a = 1 - b;
                const double divergence = b * (px[i] + py[i] + pz[i]) + a * (px[i - back] + py[i - back] + pz[i - back]);
                f[i] = (r[i] - 1) * (sx[i] * (b * x[i] + a * x[i - back]) + sy[i] * (b * y[i] + a * y[i - back]) +
                                     sz[i] * (b * z[i] + a * z[i - back]) - along[i] * divergence);
            }
        }
}

void add_inflow(const core::BlockGeometry& geometry, double factor, core::FaceView<const double> flux, core::View<double> out)
{
    const auto volume = geometry.volume.view();
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) {
        const double net =
            (flux.i(i + 1, j, k) - flux.i(i, j, k)) + (flux.j(i, j + 1, k) - flux.j(i, j, k)) + (flux.k(i, j, k + 1) - flux.k(i, j, k));
        out(i, j, k) += factor * net / volume(i, j, k);
    });
}

} // namespace

void add_transposed_stress(const TransposedStress& stress, double time, core::FaceView<double> scratch, core::VectorView<double> out)
{
    for (int c = 0; c < 3; ++c) {
        for (int axis = 0; axis < 3; ++axis) flux_along(stress, axis, c, scratch.along(axis));
        sub_face_transposed_flux(stress.geometry, stress.gradients, c, stress.ratio, scratch);
        for (const core::Side side : core::all_sides)
            if (stress.walls.at(side).kind)
                for_each_side_face(stress.geometry.cells, side,
                                   [&](int i, int j, int k) { scratch.along(core::axis_of(side))(i, j, k) = 0; });
        add_inflow(stress.geometry, time * stress.viscosity, scratch, out.component(c));
    }
}

} // namespace physics

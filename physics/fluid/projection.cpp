// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/projection.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/sub_face_flux.hpp"

namespace physics {
namespace {

void add_pressure_smoothing_along(const core::FaceMetrics& face, int axis, double mobility, double diffusion,
                                  core::VectorView<const double> gradient, core::View<const double> compact, core::View<double> flux)
{
    const core::Extents n = flux.extents();
    const std::ptrdiff_t back = gradient.x.stride(axis);
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *w = face.weight.view().row(j, k), *t = face.transmissibility.view().row(j, k), *sx = face.area_x.view().row(j, k),
                         *sy = face.area_y.view().row(j, k), *sz = face.area_z.view().row(j, k);
            const double *gx = gradient.x.row(j, k), *gy = gradient.y.row(j, k), *gz = gradient.z.row(j, k), *c = compact.row(j, k);
            double* f = flux.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const double b = w[i], a = 1 - b;
                const double interpolated = sx[i] * (b * gx[i] + a * gx[i - back]) + sy[i] * (b * gy[i] + a * gy[i - back]) +
                                            sz[i] * (b * gz[i] + a * gz[i - back]);
                // Six faces as near as this one make the diagonal of the implicit operator.
                const double diagonal = 1 + 6 * diffusion * t[i] * t[i] / (sx[i] * sx[i] + sy[i] * sy[i] + sz[i] * sz[i]);
                f[i] += mobility / diagonal * (interpolated - c[i]);
            }
        }
}

} // namespace

void add_pressure_smoothing(const core::BlockGeometry& geometry, const BlockWalls& walls, double mobility, double diffusion,
                            core::View<const double> pressure, core::VectorView<const double> pressure_gradient,
                            core::FaceView<double> scratch, core::FaceView<double> flux)
{
    gradient_flux(geometry, pressure, pressure_gradient, scratch);
    pressure_wall_flux(geometry, walls, pressure, scratch);
    for (int axis = 0; axis < 3; ++axis)
        add_pressure_smoothing_along(geometry.face[std::size_t(axis)], axis, mobility, diffusion, pressure_gradient, scratch.along(axis),
                                     flux.along(axis));
    smooth_joined_pressure(geometry, {mobility, diffusion}, pressure_gradient, scratch, flux);
}

void correct_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> psi,
                  core::VectorView<const double> psi_gradient, core::FaceView<double> scratch, core::FaceView<double> flux)
{
    gradient_flux(geometry, psi, psi_gradient, scratch);
    pressure_wall_flux(geometry, walls, psi, scratch);
    map_faces(
        flux, [](double f, double s) { return f - s; }, flux, scratch);
}

} // namespace physics

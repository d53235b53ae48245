// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/diffusion.hpp"

namespace physics {

void diffusive_inflow(const core::BlockGeometry& geometry, const BlockWalls& walls, core::View<const double> q,
                      core::VectorView<const double> gradients, core::FaceView<double> flux, core::View<double> inflow)
{
    gradient_flux(geometry, q, gradients, flux);
    wall_gradient_flux(geometry, walls, q, flux);
    net_outflow(flux, inflow);
}

void viscous_acceleration(const core::BlockGeometry& geometry, double viscosity, core::View<const double> inflow,
                          core::View<double> out)
{
    const auto volume = geometry.volume.view();
    const core::Extents n = geometry.cells;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *v = volume.row(j, k), *in = inflow.row(j, k);
            double* o = out.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) o[i] = viscosity * in[i] / v[i];
        }
}

void transmissibility_sum(const core::BlockGeometry& geometry, core::View<double> sum)
{
    const auto i_face = geometry.face[0].transmissibility.view(), j_face = geometry.face[1].transmissibility.view(),
               k_face = geometry.face[2].transmissibility.view();
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) {
        sum(i, j, k) = i_face(i, j, k) + i_face(i + 1, j, k) + j_face(i, j, k) + j_face(i, j + 1, k) + k_face(i, j, k) +
                       k_face(i, j, k + 1);
    });
}

} // namespace physics

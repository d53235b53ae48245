// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/viscous_residual.hpp"

namespace physics {

ViscousSums form_viscous_residual(const ViscousBalance& balance, core::View<double> residual)
{
    const core::Extents n = residual.extents();
    ViscousSums sums;
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *volume = balance.volume.row(j, k), *velocity = balance.velocity.row(j, k), *change = balance.change.row(j, k);
            double* r = residual.row(j, k);
            double residuals = 0, changes = 0, momenta = 0;
#pragma omp simd reduction(+ : residuals, changes, momenta)
            for (int i = 0; i < n.ni; ++i) {
                const double viscous = balance.diffusion * r[i], momentum = volume[i] * velocity[i];
                const double rest = viscous - volume[i] * change[i];
                r[i] = rest;
                residuals += rest * rest;
                changes += viscous * viscous;
                momenta += momentum * momentum;
            }
            sums += {residuals, changes, momenta};
        }
    return sums;
}

void add_jacobi_step(core::View<const double> residual, core::View<const double> reciprocal, core::View<double> velocity,
                     core::View<double> change)
{
    const core::Extents n = residual.extents();
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *r = residual.row(j, k), *d = reciprocal.row(j, k);
            double *u = velocity.row(j, k), *x = change.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) {
                const double step = r[i] * d[i];
                u[i] += step;
                x[i] += step;
            }
        }
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/cell_loops.hpp"

namespace physics {
namespace {

/// Row pointers of the six different entries of the matrices.
struct MatrixRow {
    const double *xx, *xy, *xz, *yy, *yz, *zz;
    MatrixRow(const core::GradientMatrices& m, int j, int k)
        : xx(m.xx.view().row(j, k)),
          xy(m.xy.view().row(j, k)),
          xz(m.xz.view().row(j, k)),
          yy(m.yy.view().row(j, k)),
          yz(m.yz.view().row(j, k)),
          zz(m.zz.view().row(j, k))
    {
    }
};

} // namespace

void gradient(const core::BlockGeometry& geometry, const core::GradientMatrices& matrices, core::View<const double> q,
              core::VectorView<double> out)
{
    const auto cx = geometry.centre_x.view(), cy = geometry.centre_y.view(), cz = geometry.centre_z.view();
    const std::ptrdiff_t cj = cx.stride(1), ck = cx.stride(2), qj = q.stride(1), qk = q.stride(2);
    const core::Extents n = geometry.cells;
    const auto inverse = [&](std::size_t axis) { return geometry.face[axis].inverse_square.view(); };
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *x = cx.row(j, k), *y = cy.row(j, k), *z = cz.row(j, k), *v = q.row(j, k);
            const double *wi = inverse(0).row(j, k), *low_j = inverse(1).row(j, k), *high_j = inverse(1).row(j + 1, k),
                         *low_k = inverse(2).row(j, k), *high_k = inverse(2).row(j, k + 1);
            double *gx = out.x.row(j, k), *gy = out.y.row(j, k), *gz = out.z.row(j, k);
            const MatrixRow m(matrices, j, k);
#pragma omp simd simdlen(4) // rows are short: what does not fill more lanes is left to them one by one
            for (int i = 0; i < n.ni; ++i) {
                double bx = 0, by = 0, bz = 0;
                const auto add = [&](std::ptrdiff_t c, std::ptrdiff_t s, double weight) {
                    const double w = (v[i + s] - v[i]) * weight;
                    bx += w * (x[i + c] - x[i]);
                    by += w * (y[i + c] - y[i]);
                    bz += w * (z[i + c] - z[i]);
                };
                add(-1, -1, wi[i]);
                add(1, 1, wi[i + 1]);
                add(-cj, -qj, low_j[i]);
                add(cj, qj, high_j[i]);
                add(-ck, -qk, low_k[i]);
                add(ck, qk, high_k[i]);
                gx[i] = m.xx[i] * bx + m.xy[i] * by + m.xz[i] * bz;
                gy[i] = m.xy[i] * bx + m.yy[i] * by + m.yz[i] * bz;
                gz[i] = m.xz[i] * bx + m.yz[i] * by + m.zz[i] * bz;
            }
        }
}

void vorticity(core::VectorView<const double> gradient_x, core::VectorView<const double> gradient_y,
               core::VectorView<const double> gradient_z, core::VectorView<double> curl)
{
    const auto difference = [](double a, double b) { return a - b; };
    map_cells(curl.x, difference, gradient_z.y, gradient_y.z);
    map_cells(curl.y, difference, gradient_x.z, gradient_z.x);
    map_cells(curl.z, difference, gradient_y.x, gradient_x.y);
}

} // namespace physics

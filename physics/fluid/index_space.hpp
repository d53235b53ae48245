// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Vectors in the index space of a block: components along its grid lines, in cells.
#include "core/grid/geometry.hpp"

namespace physics {

/// Components of a vector.
struct Components {
    double x, y, z;
};

/// Row pointers of d(xi_m)/d(x_j): the first letter is m, the second j.
struct InverseJacobianRow {
    const double *xx, *xy, *xz, *yx, *yy, *yz, *zx, *zy, *zz;
    InverseJacobianRow(const core::BlockGeometry& g, int j, int k, int first = 0)
        : xx(at(g, 0, 0, j, k) + first),
          xy(at(g, 0, 1, j, k) + first),
          xz(at(g, 0, 2, j, k) + first),
          yx(at(g, 1, 0, j, k) + first),
          yy(at(g, 1, 1, j, k) + first),
          yz(at(g, 1, 2, j, k) + first),
          zx(at(g, 2, 0, j, k) + first),
          zy(at(g, 2, 1, j, k) + first),
          zz(at(g, 2, 2, j, k) + first)
    {
    }
    /// Components in index space of a vector in cell i of the row.
    [[nodiscard]] Components of(int i, const Components& v) const
    {
        return {xx[i] * v.x + xy[i] * v.y + xz[i] * v.z, yx[i] * v.x + yy[i] * v.y + yz[i] * v.z, zx[i] * v.x + zy[i] * v.y + zz[i] * v.z};
    }
    /// The vector in space that has these components in index space, by Cramer's rule.
    [[nodiscard]] Components in_space(int i, const Components& c) const
    {
        const double ax = yy[i] * zz[i] - yz[i] * zy[i], ay = yz[i] * zx[i] - yx[i] * zz[i], az = yx[i] * zy[i] - yy[i] * zx[i];
        const double bx = xz[i] * zy[i] - xy[i] * zz[i], by = xx[i] * zz[i] - xz[i] * zx[i], bz = xy[i] * zx[i] - xx[i] * zy[i];
        const double cx = xy[i] * yz[i] - xz[i] * yy[i], cy = xz[i] * yx[i] - xx[i] * yz[i], cz = xx[i] * yy[i] - xy[i] * yx[i];
        const double scale = 1 / (xx[i] * ax + xy[i] * ay + xz[i] * az);
        const double p = scale * c.x, q = scale * c.y, r = scale * c.z;
        return {ax * p + bx * q + cx * r, ay * p + by * q + cy * r, az * p + bz * q + cz * r};
    }

private:
    static const double* at(const core::BlockGeometry& g, std::size_t m, std::size_t n, int j, int k)
    {
        return g.inverse_jacobian[m][n].view().row(j, k);
    }
};

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/gradient_matrices.hpp"

#include <Eigen/Dense>

namespace core {
namespace {

/// Inverse of a symmetric positive semi-definite matrix; directions without neighbours get no gradient.
Mat3 pseudo_inverse(const Mat3& m)
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(m);
    const double largest = solver.eigenvalues().maxCoeff();
    Mat3 inverse = Mat3::Zero();
    for (int n = 0; n < 3; ++n) {
        const double value = solver.eigenvalues()[n];
        const Vec3 direction = solver.eigenvectors().col(n);
        if (value > 1e-9 * largest) inverse += direction * direction.transpose() / value;
    }
    return inverse;
}

void store(GradientMatrices& m, Index3 c, const Mat3& a)
{
    m.xx(c.i, c.j, c.k) = a(0, 0);
    m.xy(c.i, c.j, c.k) = a(0, 1);
    m.xz(c.i, c.j, c.k) = a(0, 2);
    m.yy(c.i, c.j, c.k) = a(1, 1);
    m.yz(c.i, c.j, c.k) = a(1, 2);
    m.zz(c.i, c.j, c.k) = a(2, 2);
}

} // namespace

GradientMatrices gradient_matrices(const BlockGeometry& geometry, const std::array<bool, 6>& part)
{
    const Extents n = geometry.cells;
    GradientMatrices matrices;
    for (auto* array : {&matrices.xx, &matrices.xy, &matrices.xz, &matrices.yy, &matrices.yz, &matrices.zz})
        *array = Array3<double>(n, 0, 0.0);
    for_each_cell(n, [&](int i, int j, int k) {
        const Index3 c{i, j, k};
        Mat3 sum = Mat3::Zero();
        for (const Side s : all_sides) {
            const int axis = axis_of(s);
            Index3 beyond = c;
            beyond[axis] += is_high(s) ? 1 : -1;
            if (!n.contains(beyond) && !part[std::size_t(s)]) continue;
            // Half the way to a mirrored centre, to the boundary, makes the same matrix.
            const Vec3 d = geometry.centre(beyond.i, beyond.j, beyond.k) - geometry.centre(i, j, k);
            sum += d * d.transpose() / d.squaredNorm();
        }
        store(matrices, c, pseudo_inverse(sum));
    });
    return matrices;
}

} // namespace core

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/trilinear.hpp"

#include <Eigen/LU>

namespace core {

TrilinearCell::TrilinearCell(const Vertices& vertices, Index3 c)
{
    const auto v = vertices.view();
    const auto x = [&](int i, int j, int k) -> const Vec3& { return v(c.i + i, c.j + j, c.k + k); };
    c_[0] = x(0, 0, 0);
    c_[1] = x(1, 0, 0) - c_[0];
    c_[2] = x(0, 1, 0) - c_[0];
    c_[3] = x(0, 0, 1) - c_[0];
    c_[4] = x(1, 1, 0) - x(1, 0, 0) - c_[2];
    c_[5] = x(0, 1, 1) - x(0, 1, 0) - c_[3];
    c_[6] = x(1, 0, 1) - x(0, 0, 1) - c_[1];
    c_[7] = x(1, 1, 1) - x(0, 1, 1) - x(1, 0, 1) - x(1, 1, 0) + x(1, 0, 0) + x(0, 1, 0) + x(0, 0, 1) - c_[0];
}

Vec3 TrilinearCell::position(const Vec3& t) const
{
    return c_[0] + t[0] * (c_[1] + t[1] * c_[4]) + t[1] * (c_[2] + t[2] * c_[5]) + t[2] * (c_[3] + t[0] * c_[6]) +
           t[0] * t[1] * t[2] * c_[7];
}

Mat3 TrilinearCell::jacobian(const Vec3& t) const
{
    Mat3 j;
    j.col(0) = c_[1] + t[1] * c_[4] + t[2] * c_[6] + t[1] * t[2] * c_[7];
    j.col(1) = c_[2] + t[0] * c_[4] + t[2] * c_[5] + t[0] * t[2] * c_[7];
    j.col(2) = c_[3] + t[1] * c_[5] + t[0] * c_[6] + t[0] * t[1] * c_[7];
    return j;
}

std::optional<Vec3> TrilinearCell::inverse(const Vec3& x, Vec3 xi) const
{
    constexpr int most_steps = 25;
    constexpr double largest_move = 1.0; // keeps the iterate where the map is still one-to-one
    for (int n = 0; n < most_steps; ++n) {
        const Mat3 j = jacobian(xi);
        const double determinant = j.determinant();
        if (!(determinant > 0)) return std::nullopt;
        Vec3 move = j.inverse() * (x - position(xi));
        if (move.norm() > largest_move) move *= largest_move / move.norm();
        xi += move;
        if (xi.cwiseAbs().maxCoeff() > 10) return std::nullopt;
        if (move.cwiseAbs().maxCoeff() < 1e-13) return xi;
    }
    return std::nullopt;
}

} // namespace core

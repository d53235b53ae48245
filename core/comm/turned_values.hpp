// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers of a vector or a tensor in axes that are turned.
#include "core/field/field.hpp"

namespace core {

/// The values of all arrays of a vector or tensor field in one cell; those that it does not have are 0.
using CellValues = std::array<double, 9>;

[[nodiscard]] inline CellValues turned_vector(const Mat3& turn, const CellValues& v)
{
    const Vec3 t = turn * Vec3(v[0], v[1], v[2]);
    return {t.x(), t.y(), t.z()};
}

/// Of a TensorView: the components of the vector turn, and the axes along which they are differentiated.
[[nodiscard]] inline CellValues turned_tensor(const Mat3& turn, const CellValues& g)
{
    Mat3 gradient;
    gradient << g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8];
    const Mat3 t = turn * gradient * turn.transpose();
    return {t(0, 0), t(0, 1), t(0, 2), t(1, 0), t(1, 1), t(1, 2), t(2, 0), t(2, 1), t(2, 2)};
}

} // namespace core

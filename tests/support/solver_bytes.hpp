// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Memory of operator and preconditioner.
#include "physics/fluid/seven_point_solver.hpp"

namespace test {

/// Operator and preconditioner for each cell: 64-bit coefficients of faces and links, and all levels of the multigrid.
[[nodiscard]] inline double matrix_bytes(const physics::SevenPointSolver& solver, double cells)
{
    const auto& a = solver.matrix();
    double bytes = 8.0 * double(a.link.size() + a.half.size());
    for (const auto& face : a.face) bytes += 8.0 * double(face.size());
    return (bytes + double(solver.multigrid().bytes())) / cells;
}

} // namespace test

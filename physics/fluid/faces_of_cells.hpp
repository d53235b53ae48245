// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Loops that combine the values on the six faces of a cell.
#include "core/field/field.hpp"

namespace physics {

/// out = body(low face, high face along i, the same along j, along k) for every cell.
template <class Body>
void map_faces_of_cells(core::View<double> out, core::FaceView<const double> faces, Body body)
{
    const core::Extents n = out.extents();
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) {
            const double *fi = faces.i.row(j, k), *low_j = faces.j.row(j, k), *high_j = faces.j.row(j + 1, k), *low_k = faces.k.row(j, k),
                         *high_k = faces.k.row(j, k + 1);
            double* o = out.row(j, k);
#pragma omp simd
            for (int i = 0; i < n.ni; ++i) o[i] = body(fi[i], fi[i + 1], low_j[i], high_j[i], low_k[i], high_k[i]);
        }
}

} // namespace physics

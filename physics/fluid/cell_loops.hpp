// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Loops that combine values of the same cell, or of the same face.
#include "core/field/field.hpp"

namespace physics {

/// out = body(in...) for every interior element; views may be the same.
template <class Body, class... In>
void map_cells(core::View<double> out, Body body, const In&... in)
{
    const core::Extents n = out.extents();
    const auto row = [&](double* o, auto... pointers) {
#pragma omp simd
        for (int i = 0; i < n.ni; ++i) o[i] = body(pointers[i]...);
    };
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) row(out.row(j, k), in.row(j, k)...);
}

/// The same for each component of vectors.
template <class Body, class... In>
void map_components(core::VectorView<double> out, Body body, const In&... in)
{
    for (int c = 0; c < 3; ++c) map_cells(out.component(c), body, in.component(c)...);
}

/// The same for every face and sub-face.
template <class Body, class... In>
void map_faces(core::FaceView<double> out, Body body, const In&... in)
{
    for (int axis = 0; axis < core::FaceView<double>::axes; ++axis) map_cells(out.along(axis), body, in.along(axis)...);
}

/// Sum of term(in...) over the interior in a fixed order: that of the vector lanes of this build within rows.
template <class Term, class First, class... In>
[[nodiscard]] double sum_cells(Term term, const First& first, const In&... in)
{
    const core::Extents n = first.extents();
    double total = 0;
    const auto row = [&](auto... pointers) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < n.ni; ++i) sum += term(pointers[i]...);
        return sum;
    };
    for (int k = 0; k < n.nk; ++k)
        for (int j = 0; j < n.nj; ++j) total += row(first.row(j, k), in.row(j, k)...);
    return total;
}

} // namespace physics

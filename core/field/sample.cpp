// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/sample.hpp"

namespace core {
namespace {

/// Calls use(halo cell, cell inside) for the layer beyond a side, its edges and corners included.
template <class Use>
void for_layer_beyond(Extents n, Side side, Use use)
{
    const int axis = axis_of(side);
    Index3 low{-1, -1, -1}, high{n.ni + 1, n.nj + 1, n.nk + 1};
    low[axis] = is_high(side) ? n[axis] : -1;
    high[axis] = low[axis] + 1;
    for_each(low, high, [&](int i, int j, int k) {
        Index3 inside{i, j, k};
        inside[axis] += is_high(side) ? -1 : 1;
        use(Index3{i, j, k}, inside);
    });
}

} // namespace

void mirror_even(const Mesh& mesh, LocalBlock block, View<double> field)
{
    for (Side side : all_sides)
        if (mesh.at_boundary(block, side))
            for_layer_beyond(field.extents(), side, [&](Index3 beyond, Index3 inside) { field[beyond] = field[inside]; });
}

void mirror_even_transpose(const Mesh& mesh, LocalBlock block, View<double> field)
{
    for (auto side = all_sides.rbegin(); side != all_sides.rend(); ++side)
        if (mesh.at_boundary(block, *side))
            for_layer_beyond(field.extents(), *side, [&](Index3 beyond, Index3 inside) {
                field[inside] += field[beyond];
                field[beyond] = 0;
            });
}

} // namespace core

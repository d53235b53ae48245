// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/sample.hpp"
#include <algorithm>

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

/// Share of the next cell in the value at the face of a cell towards it.
double share_beyond(const Mesh& mesh, const Location& at, Side side)
{
    const int axis = axis_of(side);
    const bool last = at.cell[axis] == (is_high(side) ? mesh.cells(at.block)[axis] - 1 : 0);
    if (!last || !mesh.topology().joints.joins(at.block, side)) return 0.5;
    Index3 face = at.cell;
    if (is_high(side)) ++face[axis];
    const double upper = mesh.geometry(mesh.local(at.block)).face[std::size_t(axis)].weight.view()[face];
    return std::clamp(is_high(side) ? upper : 1 - upper, 0.0, 1.0);
}

} // namespace

HatStencil hat_stencil(const Mesh& mesh, const Location& at)
{
    HatStencil s{mesh.local(at.block), at.cell, {}};
    for (int m = 0; m < 3; ++m) {
        const double from_centre = at.xi[m] - 0.5;
        const bool high = from_centre >= 0;
        if (!high) s.base[m] -= 1;
        const double part = 2 * share_beyond(mesh, at, side_of(m, high)) * from_centre;
        s.part[std::size_t(m)] = high ? part : part + 1;
    }
    return s;
}

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

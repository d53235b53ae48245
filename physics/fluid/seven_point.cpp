// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/seven_point.hpp"

#include <algorithm>

namespace physics {

void copy_coefficients(const LevelMesh& mesh, const Coefficients& from, int piece, SevenPoint<double>& to)
{
    const auto& p = mesh.layout.pieces()[std::size_t(piece)];
    const auto cells = mesh.layout.cells(p.block);
    const auto t = from.face->on(p.block);
    const int rows = cells.nj * cells.nk;
    for (int row = p.first(rows); row < p.last(rows); ++row) {
        const int j = row % cells.nj, k = row / cells.nj;
        const auto place = mesh.layout.origin(p.block) + std::ptrdiff_t(row) * cells.ni;
        std::copy_n(t.i.row(j, k) + 1, cells.ni - 1, to.face[0].data() + place + 1);
        if (j > 0) std::copy_n(t.j.row(j, k), cells.ni, to.face[1].data() + place);
        if (k > 0) std::copy_n(t.k.row(j, k), cells.ni, to.face[2].data() + place);
        if (from.shift) std::copy_n(from.shift->on(p.block).row(j, k), cells.ni, to.shift.data() + place);
    }
}

void copy_links(const LevelMesh& mesh, const Coefficients& from, std::span<const int> source, SevenPoint<double>& to)
{
    for (std::size_t l = 0; l < mesh.links.size(); ++l) to.link[l] = from.link[std::size_t(source[l])];
    for (std::size_t h = 0; h < mesh.halves.size(); ++h) to.half[h] = to.link[std::size_t(mesh.halves[h].link)];
}

} // namespace physics

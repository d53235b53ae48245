// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Cells that no solver can use are refused by name.
#include "core/base/error.hpp"
#include "core/grid/cell_edges.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/mesh.hpp"
#include <limits>

namespace core {
namespace {

constexpr double smallest_jacobian = 1e-8; // of the product of the edges at a corner
constexpr double no_length = 1e-9;         // of the cell's longest edge

bool has_length(const Vertices& v, int axis, Index3 low, double smallest)
{
    Index3 high = low;
    ++high[axis];
    return (v.view()[high] - v.view()[low]).norm() > smallest;
}

/// The side of the block that has collapsed to a line, if an edge without length lies on one: there the next edge has none either.
std::string collapsed_side(const Vertices& v, int axis, Index3 low, double smallest)
{
    const Extents cells = cells_of(v);
    for (int m = 0; m < 3; ++m) {
        if (m == axis || (low[m] != 0 && low[m] != cells[m])) continue;
        const int other = 3 - axis - m;
        Index3 next = low;
        next[other] += low[other] < cells[other] ? 1 : -1;
        if (!has_length(v, axis, next, smallest)) return text(": side ", side_words[std::size_t(side_of(m, low[m] != 0))], " is collapsed");
    }
    return "";
}

[[noreturn]] void refuse(const Vertices& v, BlockId block, Index3 c, double jacobian)
{
    const std::string cell = text("cell (", c.i, ", ", c.j, ", ", c.k, ") of block ", block);
    for_each(c, {c.i + 2, c.j + 2, c.k + 2},
             [&](int i, int j, int k) { require<ConfigError>(v(i, j, k).allFinite(), cell + " has a corner whose place is no number"); });
    const double smallest = no_length * mean_edges(v, c).maxCoeff();
    for_each_edge(c, [&](int axis, Index3 low, Index3) {
        if (has_length(v, axis, low, smallest)) return;
        throw ConfigError(text(cell, " has an edge of no length along ", "ijk"[axis], collapsed_side(v, axis, low, smallest),
                               "; surround such an axis or point with a core and wings instead"));
    });
    throw ConfigError(text(cell, " is folded or flat: its smallest corner Jacobian is ", jacobian, " of the product of its edges"));
}

} // namespace

double checked_volume(const MultiBlock& grid, BlockId block)
{
    const Vertices& v = grid.blocks[std::size_t(block)];
    double volume = 0;
    std::ptrdiff_t left_handed = 0;
    double worst = std::numeric_limits<double>::infinity();
    Index3 where;
    for_each_cell(cells_of(v), [&](int i, int j, int k) {
        const double jacobian = smallest_corner_jacobian(v, {i, j, k}), cell = cell_shape(v, {i, j, k}).volume;
        if (!(jacobian > smallest_jacobian) && worst > smallest_jacobian) { // the first one is told
            worst = jacobian;
            where = {i, j, k};
        }
        left_handed += cell < 0;
        volume += cell;
    });
    require<ConfigError>(left_handed < cells_of(v).size(), text("block ", block,
                                                                " is left-handed: all its cells have a negative volume; count one "
                                                                "of its three directions from the other end"));
    if (!(worst > smallest_jacobian)) refuse(v, block, where, worst);
    return volume;
}

} // namespace core

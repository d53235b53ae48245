// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/pipe.hpp"
#include "core/base/error.hpp"

namespace core {
namespace {

/// One part of the section between two cuts along x. The longest direction comes first, for the sake of vector loops: across
/// the core, or along the rim; then the axis.
Vertices extrude(const Pipe& p, int block_along, int part)
{
    const int nj = p.axial_cells / p.blocks_along;
    const auto cells = butterfly_cells(p, part);
    Vertices v({cells[1] + 1, nj + 1, cells[0] + 1}, 0, Vec3::Zero());
    for_each_cell(v.extents(), [&](int i, int j, int k) {
        const Eigen::Vector2d yz = butterfly_point(p, part, k, i);
        v(i, j, k) = Vec3(p.length * (block_along * nj + j) / p.axial_cells, yz.x(), yz.y());
    });
    return v;
}

} // namespace

MultiBlock make_pipe(const Pipe& p)
{
    check(p);
    require<ConfigError>(p.length > 0, "a pipe needs a positive length");
    require<ConfigError>(p.blocks_along > 0 && p.axial_cells > 0 && p.axial_cells % p.blocks_along == 0,
                         text("a pipe of ", p.axial_cells, " cells along its axis does not divide into ", p.blocks_along, " blocks"));
    MultiBlock grid;
    for (int along = 0; along < p.blocks_along; ++along)
        for (int part = 0; part < butterfly_parts; ++part) grid.blocks.push_back(extrude(p, along, part));
    if (p.periodic) grid.periods.push_back(p.length * Vec3::UnitX());
    grid.boundary_name = [](BlockId, Side s) { return std::string(s == Side::j_low ? "x_low" : s == Side::j_high ? "x_high" : "wall"); };
    return grid;
}

} // namespace core

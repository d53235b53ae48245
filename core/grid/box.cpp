// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/box.hpp"
#include "core/base/error.hpp"

namespace core {

MultiBlock make_box(const Box& box, const std::function<Vec3(const Vec3&)>& map)
{
    for (int m = 0; m < 3; ++m)
        require<ConfigError>(box.blocks[m] > 0 && box.cells[m] >= box.blocks[m] && box.cells[m] % box.blocks[m] == 0,
                             text("a box of ", box.cells[m], " cells does not divide into ", box.blocks[m], " blocks along axis ", m));
    const Extents n{box.cells.ni / box.blocks.ni, box.cells.nj / box.blocks.nj, box.cells.nk / box.blocks.nk};
    MultiBlock grid;
    for_each_cell(box.blocks, [&](int bi, int bj, int bk) {
        Vertices vertices({n.ni + 1, n.nj + 1, n.nk + 1}, 0, Vec3::Zero());
        for_each_cell(vertices.extents(), [&](int i, int j, int k) {
            const Vec3 part(double(bi * n.ni + i) / box.cells.ni, double(bj * n.nj + j) / box.cells.nj,
                            double(bk * n.nk + k) / box.cells.nk);
            vertices(i, j, k) = map(box.low + part.cwiseProduct(box.high - box.low));
        });
        grid.blocks.push_back(std::move(vertices));
    });
    for (int m = 0; m < 3; ++m)
        if (box.periodic[std::size_t(m)]) grid.periods.push_back((box.high - box.low)[m] * Vec3::Unit(m));
    grid.boundary_name = [](BlockId, Side s) { return std::string(1, char('x' + axis_of(s))) + (is_high(s) ? "_high" : "_low"); };
    return grid;
}

} // namespace core

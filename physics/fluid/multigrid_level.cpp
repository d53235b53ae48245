// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_level.hpp"

#include <algorithm>

namespace physics {
namespace {

/// The children next to the side of a run; none if the axis was not halved there.
SideChildren children_beside(const SideRun& run, const BlockLayout& coarse, const BlockLayout& fine, core::LocalBlock fine_block)
{
    const auto cells = fine.cells(fine_block);
    const auto place = cell_place(coarse.cells(run.block), run.cell);
    const int axis = axis_of(run.side), n = cells[axis];
    if (n == 1 || (is_high(run.side) && n % 2 != 0)) return {};
    core::Index3 low{2 * place.i, 2 * place.j, 2 * place.k};
    core::Index3 high{std::min(low.i + 2, cells.ni), std::min(low.j + 2, cells.nj), std::min(low.k + 2, cells.nk)};
    low[axis] = is_high(run.side) ? n - 1 : 0;
    high[axis] = low[axis] + 1;
    SideChildren result;
    core::for_each(low, high, [&](int i, int j, int k) {
        result.at[std::size_t(result.count++)] = int(fine.origin(fine_block)) + cell_index(cells, i, j, k);
    });
    return result;
}

void make_vectors(bool with_shift, MultigridLevel& level)
{
    level.matrix = make_seven_point<float>(level.mesh, with_shift);
    for (auto* v : {&level.inverse, &level.right, &level.residual, &level.direction, &level.solution, &level.other})
        v->assign(level.mesh.layout.size(), 0.0F);
}

void make_transfer(MultigridLevel& level)
{
    for (std::size_t side = 0; side < 6; ++side) {
        level.weight[side].assign(level.mesh.layout.size(), 0.0F);
        level.side_part[side].assign(level.mesh.layout.size(), 0.0F);
    }
    level.half_weight.assign(level.mesh.halves.size(), 0.0F);
    level.half_part.assign(level.mesh.halves.size(), 0.0F);
    level.half_received.assign(level.mesh.halves.size(), 0.0F);
}

} // namespace

MultigridLevel make_multigrid_level(const BlockTopology& topology, bool with_shift, const core::Communicator& ranks)
{
    MultigridLevel level(make_level_mesh(topology));
    make_vectors(with_shift, level);
    level.axis.assign(std::size_t(level.mesh.layout.blocks()), LineAxis::none);
    level.end_resistance.assign(level.mesh.links.size(), {0.0F, 0.0F});
    level.is_shared = ranks.size() > 1;
    level.chains = LineChains(side_patches(topology, ranks), topology);
    level.choices.resize(topology.cells.size());
    return level;
}

void tie_levels(MultigridLevel& fine, MultigridLevel& coarse)
{
    coarse.fine_block.assign(std::size_t(coarse.mesh.layout.blocks()), -1);
    for (core::LocalBlock b = 0; b < fine.mesh.layout.blocks(); ++b) {
        const auto ids = coarse.mesh.layout.ids();
        const auto at = std::lower_bound(ids.begin(), ids.end(), fine.mesh.layout.id(b)) - ids.begin();
        fine.coarse_block.push_back(int(at));
        coarse.fine_block[std::size_t(at)] = b;
    }
    for (const auto& run : coarse.mesh.runs) {
        const auto b = coarse.fine_block[std::size_t(run.block)];
        coarse.side_children.push_back(b < 0 ? SideChildren{} : children_beside(run, coarse.mesh.layout, fine.mesh.layout, b));
    }
    make_transfer(coarse);
}

void release(MultigridLevel& coarse)
{
    coarse.matrix = {};
    const auto give_back = [](std::vector<float>& v) { v = std::vector<float>(); }; // an assigned list would keep the capacity
    for (auto* v : {&coarse.inverse, &coarse.right, &coarse.residual, &coarse.direction, &coarse.solution, &coarse.other}) give_back(*v);
    for (std::size_t side = 0; side < 6; ++side) {
        give_back(coarse.weight[side]);
        give_back(coarse.side_part[side]);
    }
}

void restore(bool with_shift, MultigridLevel& coarse)
{
    make_vectors(with_shift, coarse);
    make_transfer(coarse);
}

} // namespace physics

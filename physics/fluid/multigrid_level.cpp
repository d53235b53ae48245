// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_level.hpp"

namespace physics {

MultigridLevel make_multigrid_level(const BlockTopology& topology, bool with_shift)
{
    MultigridLevel level(make_level_mesh(topology));
    level.matrix = make_seven_point<float>(level.mesh, with_shift);
    level.axis.assign(std::size_t(level.mesh.layout.blocks()), LineAxis::none);
    for (auto* v : {&level.inverse, &level.right, &level.residual, &level.direction, &level.solution, &level.other})
        v->assign(level.mesh.layout.size(), 0.0F);
    level.end_resistance.assign(level.mesh.links.size(), {0.0F, 0.0F});
    return level;
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

} // namespace physics

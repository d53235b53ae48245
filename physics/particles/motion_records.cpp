// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/motion_records.hpp"
#include "core/base/four.hpp"
#include "core/base/renew.hpp"

#include <algorithm>

namespace physics {
namespace {

void update_four(const core::ParticleSet& p, std::size_t i, MotionRecords::Record* records)
{
    const auto four = [i](const core::Column& column) { return core::load_four(column.data() + i); };
    core::Four x[] = {four(p.position[0]), four(p.position[1]), four(p.position[2]), 1.0 / four(p.mass)};
    core::Four v[] = {four(p.velocity[0]), four(p.velocity[1]), four(p.velocity[2]), core::Four{}};
    core::Four w[] = {four(p.spin[0]), four(p.spin[1]), four(p.spin[2]), four(p.radius)};
    for (auto* rows : {x, v, w}) core::transpose(rows[0], rows[1], rows[2], rows[3]);
    for (std::size_t k = 0; k < 4; ++k) {
        core::store_four(records[k].motion, x[k]);
        core::store_four(records[k].motion + 4, v[k]);
        core::store_four(records[k].spin, w[k]);
    }
}

} // namespace

void MotionRecords::plan(const core::ParticleSet& particles, const core::PairList& pairs, const core::ChunkPlan& chunks)
{
    windows_.plan(pairs, chunks, particles.owned, particles.ghosts());
    core::renew(records_, std::size_t(windows_.count));
    update_ghosts(particles);
}

void MotionRecords::update_ghosts(const core::ParticleSet& particles)
{
    if (windows_.first_ghost < particles.size()) update(particles, windows_.first_ghost, particles.size(), -windows_.first_ghost);
}

void MotionRecords::copy(const core::ParticleSet& particles, int segment, int chunk)
{
    const int begin = chunk * core::particles_per_chunk;
    update(particles, begin, std::min(particles.size(), begin + core::particles_per_chunk),
           windows_.offset[std::size_t(segment)][std::size_t(chunk)]);
}

/// Copies particles [begin, end).
void MotionRecords::update(const core::ParticleSet& p, int begin, int end, int offset)
{
    Record* const to = records_.data() + offset;
    auto i = std::size_t(begin);
    for (; i + 4 <= std::size_t(end); i += 4) update_four(p, i, to + i);
    for (; i < std::size_t(end); ++i)
        to[i] = {{p.position[0][i], p.position[1][i], p.position[2][i], 1.0 / p.mass[i], p.velocity[0][i], p.velocity[1][i],
                  p.velocity[2][i], 0.0},
                 {p.spin[0][i], p.spin[1][i], p.spin[2][i], p.radius[i]}};
}

} // namespace physics

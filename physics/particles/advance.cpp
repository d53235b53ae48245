// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/advance.hpp"

#include <algorithm>

namespace physics {
namespace {

void rebuild(ParticleDynamics& dynamics, const core::Team& team)
{
    auto& particles = dynamics.particles;
    double greatest = 0.0;
    for (int i = 0; i < particles.owned; ++i) greatest = std::max(greatest, particles.radius[std::size_t(i)]);
    dynamics.set_reach(greatest);
    dynamics.dissolve(team);
    dynamics.sort(core::make_bin_lattice(dynamics.domain(), dynamics.bounds(), dynamics.cutoff(), particles.owned));
    dynamics.build(team);
}

} // namespace

void settle(ParticleDynamics& dynamics, const Motion& motion, int sub_steps, const core::Team& team, const core::Communicator&)
{
    double time = 0.5 * dynamics.step(), speed2 = dynamics.start(team);
    for (int k = 0; k < sub_steps; ++k) {
        dynamics.account(speed2, time);
        if (dynamics.needs_check() && !dynamics.keep_lists(dynamics.displacement())) rebuild(dynamics, team);
        speed2 = dynamics.advance(motion, team, k, sub_steps);
        time = dynamics.step();
    }
    dynamics.account(speed2, time);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/gathered_particles.hpp"
#include <algorithm>
#include <cstring>

namespace io {

std::vector<GatheredParticle> gather_particles(const physics::ParticleDynamics& grains, const core::Communicator& ranks)
{
    const core::ParticleSet& particles = grains.particles;
    const core::Domain& domain = grains.domain();
    std::vector<GatheredParticle> mine;
    for (int i = 0; i < particles.owned; ++i) {
        const auto n = std::size_t(i);
        GatheredParticle& p = mine.emplace_back(GatheredParticle{particles.id[n], particles.species[n], {}, particles.radius[n]});
        for (int axis = 0; axis < 3; ++axis)
            p.position[std::size_t(axis)] = domain.origin[axis] + domain.wrapped(axis, particles.position_of(i)[axis]);
    }
    std::vector<std::vector<std::byte>> to(std::size_t(ranks.size()));
    const auto bytes = std::as_bytes(std::span<const GatheredParticle>(mine));
    to[0].assign(bytes.begin(), bytes.end());
    std::vector<GatheredParticle> all;
    for (const auto& part : ranks.exchange_all(to)) {
        const std::size_t old = all.size();
        all.resize(old + part.size() / sizeof(GatheredParticle));
        if (!part.empty()) std::memcpy(all.data() + old, part.data(), part.size());
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return all;
}

} // namespace io

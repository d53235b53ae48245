// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of all ranks in one list, for pictures.
#include "core/comm/communicator.hpp"
#include "physics/particles/dynamics.hpp"

namespace io {

struct GatheredParticle {
    std::int64_t id = 0;
    std::int64_t species = 0;
    std::array<double, 3> position{}; ///< in the user's coordinates, periodic images brought into the domain [m]
    double radius = 0.0;              ///< [m]
};

/// All particles in the order of their ids, on rank 0; nothing on the others. Collective.
[[nodiscard]] std::vector<GatheredParticle> gather_particles(const physics::ParticleDynamics& grains, const core::Communicator& ranks);

} // namespace io

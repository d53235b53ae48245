// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the user chooses for the particles: contacts between species and with walls, gravity, lists, time step.
#include "core/base/vec3.hpp"

#include <cstdint>
#include <vector>

namespace physics {

/// Contact between two materials.
struct ContactParameters {
    double stiffness = 1000.0;               ///< Normal spring k_n [N/m].
    double tangential_stiffness = 2.0 / 7.0; ///< k_t / k_n [-].
    double restitution = 0.6;                ///< Rebound speed over approach speed, head-on, 0.01..1 [-].
    double friction = 0.5;                   ///< Coulomb's coefficient [-].
};

struct ParticleParameters {
    int species = 1;
    /// species x species, row-major and symmetric; one entry serves all species.
    std::vector<ContactParameters> pairs{ContactParameters{}};
    /// One for each species, or one for all.
    std::vector<ContactParameters> walls{ContactParameters{}};
    core::Vec3 gravity = core::Vec3::Zero(); ///< [m/s2]
    double time_step = 0.0;                  ///< [s]; 0: a share of the contact time, see time_step.hpp.
    double skin = 0.0;                       ///< Reach of the pair lists beyond touching [m]; 0: chosen from the radii.
    double near_skin = 0.0;                  ///< Reach of the near pairs beyond touching [m]; 0: chosen from the radii.
    std::uint64_t seed = 1;                  ///< Of all random numbers.
};

} // namespace physics

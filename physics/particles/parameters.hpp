// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the user chooses for the particles: contacts between species and with walls, gravity, lists, time step.
#include "core/base/vec3.hpp"

#include <cstdint>
#include <vector>

namespace physics {

enum class ContactModel { linear, hertz };

/// How a contact resists rolling and twisting: by a torque that is constant (A of Ai et al. 2011), or by a spring and a dashpot
/// that yield at that torque (C), which hold a particle at rest.
enum class RollingModel { constant, spring };

/// Contact between two materials.
struct ContactParameters {
    double stiffness = 1000.0;               ///< Linear: normal spring k_n [N/m].
    double tangential_stiffness = 2.0 / 7.0; ///< Linear: k_t / k_n [-].
    double restitution = 0.6;                ///< Rebound speed over approach speed, head-on, 0.01..1 [-].
    double friction = 0.5;                   ///< Coulomb's coefficient [-].
    ContactModel model = ContactModel::linear;
    double young_modulus = 0.0; ///< Hertz: effective, 1 / E = (1 - nu1^2) / E1 + (1 - nu2^2) / E2 [Pa].
    double shear_modulus = 0.0; ///< Hertz: effective, 1 / G = (2 - nu1) / G1 + (2 - nu2) / G2 [Pa].
    RollingModel rolling = RollingModel::spring;
    double rolling_friction = 0.0;  ///< Greatest torque against rolling over normal force and reduced radius [-].
    double twisting_friction = 0.0; ///< The same against twisting [-].
    double cohesion = 0.0;          ///< Work of adhesion [J/m2].
    double impact_speed = 1.0;      ///< Hertz: speed of the fastest impact, which decides the time step [m/s].
    bool operator==(const ContactParameters&) const = default;
};

/// The film of fluid between surfaces that approach or part (lubrication.hpp).
struct LubricationFilm {
    double factor = 0.0;    ///< 6 pi mu [Pa s]; 0: no film.
    double roughness = 0.0; ///< Gap below which the film resists no more [m].
    double range = 0.0;     ///< Gap from which on there is a film [m].
    bool operator==(const LubricationFilm&) const = default;
    [[nodiscard]] bool acts() const { return factor > 0.0; }
};

/// Whether the energy of contacts is booked.
enum class Budget { none, kept };

struct ParticleParameters {
    int species = 1;
    /// species x species, row-major and symmetric; one entry serves all species.
    std::vector<ContactParameters> pairs{ContactParameters{}};
    int wall_materials = 1;
    /// wall materials x species, row-major; one entry serves all.
    std::vector<ContactParameters> walls{ContactParameters{}};
    LubricationFilm film;                    ///< One for all.
    core::Vec3 gravity = core::Vec3::Zero(); ///< [m/s2]
    double time_step = 0.0;                  ///< [s]; 0: a share of the contact time, see time_step.hpp.
    double skin = 0.0;                       ///< Reach of the pair lists beyond touching [m]; 0: chosen from the radii.
    double near_skin = 0.0;                  ///< Reach of the near pairs beyond touching [m]; 0: chosen from the radii.
    Budget energy_budget = Budget::none;     ///< Kept: where the energy of the particles goes.
    std::uint64_t seed = 1;                  ///< Of all random numbers.
};

} // namespace physics

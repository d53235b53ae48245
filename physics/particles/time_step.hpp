// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long a contact lasts, and which time steps are accurate and stable.
#include "core/particles/particle_set.hpp"
#include "physics/particles/parameters.hpp"

namespace physics {

/// What meets in a contact: reduced mass [kg] and reduced radius [m]; at a wall those of the particle.
struct ContactBody {
    double mass = 0.0;
    double radius = 0.0; ///< Hertz only.
};

/// Duration of a head-on contact [s]: of linear springs with the damping ratio of `contact`, tensile end kept; of Hertz' springs
/// undamped, at the impact speed: 2.943 overlap / speed.
[[nodiscard]] double contact_time(const ContactParameters& contact, const ContactBody& body);
/// The same for linear springs. @param mass  Reduced mass [kg].
[[nodiscard]] inline double contact_time(const ContactParameters& contact, double mass)
{
    return contact_time(contact, ContactBody{mass, 0.0});
}

/// The stiffness of linear springs with which a contact lasts `time` [N/m]: the inverse of contact_time().
[[nodiscard]] double stiffness_of(double time, double mass, double restitution);

/// Greatest overlap of an undamped head-on impact of Hertz' spring at the impact speed [m]: (15 m v^2 / (16 E sqrt(R)))^(2/5).
[[nodiscard]] double greatest_overlap(const ContactParameters& contact, const ContactBody& body);

/// Stiffness along the normal [N/m]; for Hertz' springs, 2 E sqrt(R delta), at the greatest overlap of an impact. A bed as high as
/// particles fall is not pressed harder by its weight than by such an impact.
[[nodiscard]] double normal_stiffness(const ContactParameters& contact, const ContactBody& body);

/// Largest stable step [s] for a particle in `contacts` contacts: (2/omega)(sqrt(1 + zeta^2) - zeta) with
/// omega^2 = 2 contacts k / mass, k the largest of k_n, 3.5 k_t (the mode that slides) and 5.6 mu_r^2 k_n (the one that turns).
[[nodiscard]] double stable_step(const ContactParameters& contact, const ContactBody& body, double mass, int contacts);

/// What all particles allow.
struct StepLimits {
    double contact_time = 0.0; ///< Shortest of all contacts [s].
    double stable = 0.0;       ///< Limit of stability in a dense packing (12 contacts) [s].
};

/// Each particle meets its like, and walls; a rank without particles gives infinite limits.
[[nodiscard]] StepLimits step_limits(const core::ParticleSet& particles, const ParticleParameters& parameters);

/// The step to use: parameters.time_step, or the shortest contact time over 30 (within the stable step).
/// @throws core::ConfigError if the wanted step is above the stable one or resolves a contact by fewer than 20 steps.
[[nodiscard]] double choose_step(const StepLimits& limits, double wanted);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long a contact lasts, and which time steps are accurate and stable.
#include "core/particles/particle_set.hpp"
#include "physics/particles/parameters.hpp"

namespace physics {

/// Duration of a head-on contact of reduced mass `mass` [kg] with the damping ratio of `contact`, tensile end kept [s].
[[nodiscard]] double contact_time(const ContactParameters& contact, double mass);

/// Largest stable step [s] for a sphere of `mass` that sits in `contacts` contacts: (2/omega)(sqrt(1 + zeta^2) - zeta) with
/// omega^2 = 2 contacts k / mass, k the larger of k_n and 3.5 k_t (the mode that rolls).
[[nodiscard]] double stable_step(const ContactParameters& contact, double mass, int contacts);

/// What the lightest particle allows.
struct StepLimits {
    double contact_time = 0.0; ///< Shortest of all contacts [s].
    double stable = 0.0;       ///< Limit of stability in a dense packing (12 contacts) [s].
};

/// @pre at least one owned particle on some rank; a rank without gives infinite limits.
[[nodiscard]] StepLimits step_limits(const core::ParticleSet& particles, const ParticleParameters& parameters);

/// The step to use: parameters.time_step, or the shortest contact time over 30 (within the stable step).
/// @throws core::ConfigError if the wanted step is above the stable one or resolves a contact by fewer than 10 steps.
[[nodiscard]] double choose_step(const StepLimits& limits, double wanted);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The linear contact: constant springs and dashpots.
#include "physics/particles/contact_law.hpp"
#include "physics/particles/parameters.hpp"

namespace physics {

/// Constants of one pair of materials.
struct LinearContact {
    static constexpr bool resists_turning = false;
    double stiffness = 0.0;            ///< [N/m]
    double tangential_stiffness = 0.0; ///< [N/m]
    double compliance = 0.0;           ///< 1 / tangential_stiffness [m/N]; 0 if there is none.
    double damping = 0.0;              ///< Normal dashpot per root of the reduced mass [kg^1/2/s].
    double tangential_damping = 0.0;   ///< The same across the normal.
    double friction = 0.0;             ///< [-]
    double step = 0.0;                 ///< Time step [s].

    [[nodiscard]] bool operator==(const LinearContact&) const = default;
    [[gnu::always_inline, nodiscard]] inline ContactStiffness at(const ContactInput& c, double /*normal_speed*/) const
    {
        return {stiffness * c.overlap, damping, tangential_stiffness, compliance, tangential_damping, 1.0};
    }
    [[gnu::always_inline, nodiscard]] inline ContactOutput operator()(const ContactInput& c) const { return contact_force(*this, c); }
};

/// @param step  Time step [s].
/// @throws core::ConfigError for values out of range.
[[nodiscard]] LinearContact linear_contact(const ContactParameters& parameters, double step);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The contact of elastic spheres: Hertz along the normal, Mindlin across it, rescaled tangential springs.
#include "physics/particles/contact_law.hpp"
#include "physics/particles/parameters.hpp"

namespace physics {

/// Constants of one pair of materials. With the contact radius a = sqrt(R delta): normal force 4/3 E a delta, tangential stiffness
/// 8 G a. Where the load grows the tangential force stays, where it falls it falls with the stiffness: energy is never gained.
/// @source  Hertz (1882); Mindlin (1949); Thornton, Cummins and Cleary (2013), section 2, for the rescaling.
struct HertzContact {
    static constexpr bool resists_turning = false;
    double modulus = 0.0;            ///< 4/3 of the effective Young's modulus E [Pa].
    double tangential_modulus = 0.0; ///< 8 times the effective shear modulus G [Pa].
    double damping = 0.0;            ///< Normal dashpot per root of reduced mass and contact radius [kg^1/2 m^-1/2 s^-1].
    double tangential_damping = 0.0; ///< The same across the normal.
    double friction = 0.0;           ///< [-]
    double step = 0.0;               ///< Time step [s].

    [[nodiscard]] bool operator==(const HertzContact&) const = default;
    [[gnu::always_inline, nodiscard]] inline ContactStiffness at(const ContactInput& c, double normal_speed) const
    {
        const double overlap = std::max(0.0, c.overlap), before = std::max(0.0, c.overlap - step * normal_speed);
        const double reach = std::sqrt(c.radius * overlap), root = std::sqrt(reach);
        const double fade = std::min(1.0, std::sqrt(before / std::max(overlap, tiny_denominator)));
        const double tangential = tangential_modulus * reach;
        return {modulus * reach * overlap,
                damping * root,
                tangential,
                1.0 / std::max(tangential, tiny_denominator),
                tangential_damping * root,
                fade};
    }
    [[gnu::always_inline, nodiscard]] inline ContactOutput operator()(const ContactInput& c) const { return contact_force(*this, c); }
};

/// @param step  Time step [s].
/// @throws core::ConfigError for values out of range.
[[nodiscard]] HertzContact hertz_contact(const ContactParameters& parameters, double step);

} // namespace physics

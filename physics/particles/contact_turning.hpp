// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Resistance of a contact against rolling or twisting: a torque that is constant, or of a spring that yields.
#include "physics/particles/contact_law.hpp"

namespace physics {

struct TurnResistance {
    double limit;     ///< Greatest torque [N m].
    double stiffness; ///< Of the spring; 0: a constant torque [N m].
    double dashpot;   ///< While the spring holds [N m s].
    double stop;      ///< Torque over spin at which a constant torque stops the spin in one step [N m s]; 0 with a spring.
};

/// Torque on the first particle [N m] and the turn that the spring holds afterwards [rad].
struct TurnOutput {
    double mx, my, mz;
    double rx, ry, rz;
};

/// @param ux,uy,uz  Relative spin [1/s].
/// @param bx,by,bz  Turn that the spring held before [rad].
/// @source  Ai, Chen, Rotter and Ooi (2011), models A (constant torque) and C (elastic-plastic spring and dashpot). A constant torque
/// gives way to a dashpot where it would turn the spin round within a step.
[[gnu::always_inline]] inline TurnOutput resist_turn(const TurnResistance& k, double step, double ux, double uy, double uz, double bx,
                                                     double by, double bz)
{
    const double spin = std::sqrt(ux * ux + uy * uy + uz * uz);
    const double ax = bx + step * ux, ay = by + step * uy, az = bz + step * uz;
    const double trial = k.stiffness * std::sqrt(ax * ax + ay * ay + az * az);
    const bool yields = trial > k.limit;
    const double share = (yields ? k.limit / std::max(trial, tiny_denominator) : 1.0) * (k.stiffness > 0.0 ? 1.0 : 0.0);
    const double dashpot = (yields ? 0.0 : k.dashpot) + std::min(k.stop, k.limit / std::max(spin, tiny_denominator));
    const double rx = share * ax, ry = share * ay, rz = share * az;
    return {-k.stiffness * rx - dashpot * ux, -k.stiffness * ry - dashpot * uy, -k.stiffness * rz - dashpot * uz, rx, ry, rz};
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One set of constants for every law: linear or Hertz' springs, with cohesion and resistance against rolling and twisting. Scenes that
// mix laws, or want more than springs and friction, run all contacts through it, so that they stay one vector loop.
#include "physics/particles/contact_hertz.hpp"
#include "physics/particles/contact_linear.hpp"
#include "physics/particles/contact_turning.hpp"

namespace physics {

struct GeneralOutput : ContactOutput {
    double mx, my, mz; ///< Torque on the first particle; the second receives the opposite [N m].
    double rx, ry, rz; ///< Turn that the springs hold [rad].
};

/// Cohesion pulls with 2 pi w R while surfaces overlap, friction and the limits of turning follow the repulsion alone.
/// @source  Derjaguin, Muller and Toporov (1975) for the pull; Ai et al. (2011) for rolling, equations 11-18 with k_r = 2.25 k_n (mu R)^2.
struct GeneralContact {
    static constexpr bool resists_turning = true;
    LinearContact linear; ///< All zero for Hertz' springs.
    HertzContact hertz;   ///< All zero for linear springs.
    double friction = 0.0, step = 0.0;
    double rolling = 0.0;      ///< Coefficient of rolling friction [-].
    double twisting = 0.0;     ///< Of twisting friction [-].
    double turning_spring = 0; ///< 1: torques of springs that yield (C); 0: constant torques (A).
    double stop = 0.0;         ///< Share 0.4 / step of a constant torque [1/s]; 0 with springs.
    double pull = 0.0;         ///< 2 pi times the work of adhesion [J/m2].

    [[nodiscard]] bool operator==(const GeneralContact&) const = default;
    [[gnu::always_inline, nodiscard]] inline ContactStiffness at(const ContactInput& c, double normal_speed) const
    {
        const ContactStiffness a = linear.at(c, normal_speed), b = hertz.at(c, normal_speed);
        const double tangential = a.tangential + b.tangential;
        return {a.elastic + b.elastic,
                a.damping + b.damping,
                tangential,
                tangential > 0.0 ? 1.0 / std::max(tangential, tiny_denominator) : 0.0,
                a.tangential_damping + b.tangential_damping,
                b.tangential > 0.0 ? b.fade : 1.0};
    }
    [[gnu::always_inline, nodiscard]] inline GeneralOutput operator()(const ContactInput& c) const;

    /// The resistance of one kind of turning at an overlap. @param coefficient  `rolling` or `twisting`.
    [[gnu::always_inline, nodiscard]] inline TurnResistance resistance(const ContactInput& c, double overlap, double coefficient,
                                                                       double normal) const;
};

/// The turn that the springs held before, turned with the contact: rolling across the normal, twist along it [rad].
struct HeldTurn {
    double x, y, z, twist;
};

/// In a step the contact turns by 2 (m x n), as its normal does, and about it by its twist.
[[gnu::always_inline, nodiscard]] inline HeldTurn held_turn(double step, const ContactInput& c)
{
    const double angle = step * c.twist;
    const double ox = 2.0 * (c.my * c.nz - c.mz * c.ny) + angle * c.nx;
    const double oy = 2.0 * (c.mz * c.nx - c.mx * c.nz) + angle * c.ny;
    const double oz = 2.0 * (c.mx * c.ny - c.my * c.nx) + angle * c.nz;
    const double qx = c.rx + oy * c.rz - oz * c.ry, qy = c.ry + oz * c.rx - ox * c.rz, qz = c.rz + ox * c.ry - oy * c.rx;
    const double before = c.rx * c.rx + c.ry * c.ry + c.rz * c.rz, after = qx * qx + qy * qy + qz * qz;
    const double keep = std::sqrt(before / std::max(after, tiny_denominator));
    const double twist = keep * (qx * c.nx + qy * c.ny + qz * c.nz);
    return {keep * qx - twist * c.nx, keep * qy - twist * c.ny, keep * qz - twist * c.nz, twist};
}

/// The dashpot is 0.3 of the critical one for a sphere that rolls on a wall (7/5 m R^2).
inline TurnResistance GeneralContact::resistance(const ContactInput& c, double overlap, double coefficient, double normal) const
{
    constexpr double damping_ratio = 0.3, rolling_inertia = 1.4;
    const double arm = coefficient * c.radius, inertia = c.root_mass * c.root_mass * c.radius * c.radius;
    const double normal_stiffness = linear.stiffness + 1.5 * hertz.modulus * std::sqrt(c.radius * std::max(0.0, overlap));
    const double stiffness = turning_spring * 2.25 * normal_stiffness * arm * arm;
    return {arm * normal, stiffness, 2.0 * damping_ratio * std::sqrt(rolling_inertia * inertia * stiffness), stop * inertia};
}

inline GeneralOutput GeneralContact::operator()(const ContactInput& c) const
{
    GeneralOutput out = {contact_force(*this, c), 0, 0, 0, 0, 0, 0};
    const double touching = c.overlap > 0.0 ? 1.0 : 0.0, attraction = touching * pull * c.radius;
    out.fx += attraction * c.nx;
    out.fy += attraction * c.ny;
    out.fz += attraction * c.nz;
    const HeldTurn held = held_turn(step, c);
    const double un = c.ux * c.nx + c.uy * c.ny + c.uz * c.nz;
    const TurnOutput roll = resist_turn(resistance(c, c.overlap, rolling, out.normal), step, c.ux - un * c.nx, c.uy - un * c.ny,
                                        c.uz - un * c.nz, held.x, held.y, held.z);
    const TurnOutput twist = resist_turn(resistance(c, c.overlap, twisting, out.normal), step, un * c.nx, un * c.ny, un * c.nz,
                                         held.twist * c.nx, held.twist * c.ny, held.twist * c.nz);
    out.mx = touching * (roll.mx + twist.mx);
    out.my = touching * (roll.my + twist.my);
    out.mz = touching * (roll.mz + twist.mz);
    out.rx = touching * (roll.rx + twist.rx);
    out.ry = touching * (roll.ry + twist.ry);
    out.rz = touching * (roll.rz + twist.rz);
    return out;
}

/// @param step  Time step [s].
/// @throws core::ConfigError for values out of range.
[[nodiscard]] GeneralContact general_contact(const ContactParameters& parameters, double step);

} // namespace physics

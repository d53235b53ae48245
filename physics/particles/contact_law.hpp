// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The linear contact: spring and dashpot along the normal, spring, dashpot and Coulomb slider across it.
#include "physics/particles/parameters.hpp"

#include <algorithm>
#include <cmath>

namespace physics {

/// Restitution of a head-on impact with spring, dashpot and a force that never pulls [-].
/// @param damping  Damping ratio zeta = c / (2 sqrt(m k)), not negative.
/// @source  Schwager and Poeschel (2007), Coefficient of restitution and linear-dashpot model revisited.
[[nodiscard]] double restitution_of(double damping);

/// The inverse of restitution_of(). @throws core::ConfigError unless 0.01 <= restitution <= 1.
[[nodiscard]] double damping_of(double restitution);

/// One contact before the force is known. Vectors are written out so that loops over contacts become vector code.
struct ContactInput {
    double nx, ny, nz; ///< Unit normal from first to second, at the positions [-].
    double mx, my, mz; ///< Unit normal at the time of the velocities, half a step earlier [-].
    double overlap;    ///< [m]; no contact where it is not positive.
    double vx, vy, vz; ///< Velocity of the first centre against the second [m/s].
    double wx, wy, wz; ///< Spins weighted with the lever arms, first + second [m/s].
    double twist;      ///< Turn of the contact about its normal [1/s].
    double sx, sy, sz; ///< Tangential spring [m].
    double root_mass;  ///< Square root of the reduced mass [kg^1/2].
};

/// Force on the first particle [N] and the new tangential spring [m].
struct ContactOutput {
    double fx, fy, fz;
    double sx, sy, sz;
};

/// Constants of one pair of materials.
struct LinearContact {
    double stiffness = 0.0;            ///< [N/m]
    double tangential_stiffness = 0.0; ///< [N/m]
    double compliance = 0.0;           ///< 1 / tangential_stiffness [m/N]; 0 if there is none.
    double damping = 0.0;              ///< Normal dashpot per root of the reduced mass [kg^1/2/s].
    double tangential_damping = 0.0;   ///< The same across the normal.
    double friction = 0.0;             ///< [-]
    double step = 0.0;                 ///< Time step [s].

    [[nodiscard]] ContactOutput operator()(const ContactInput& c) const;
};

/// @param step  Time step [s].
/// @throws core::ConfigError for values out of range.
[[nodiscard]] LinearContact linear_contact(const ContactParameters& parameters, double step);

/// The spring follows the turn of the contact at constant length; it grows by the slip of the last step, seen in the
/// plane of the time of the velocities. A sliding contact stores the spring that carries the whole friction force and
/// has no tangential dashpot.
[[gnu::always_inline]] inline ContactOutput LinearContact::operator()(const ContactInput& c) const
{
    const double vn = c.vx * c.mx + c.vy * c.my + c.vz * c.mz;
    const double normal = std::max(0.0, stiffness * c.overlap + damping * c.root_mass * vn);
    double tx = c.vx - vn * c.mx + (c.wy * c.mz - c.wz * c.my);
    double ty = c.vy - vn * c.my + (c.wz * c.mx - c.wx * c.mz);
    double tz = c.vz - vn * c.mz + (c.wx * c.my - c.wy * c.mx);
    const double tn = tx * c.nx + ty * c.ny + tz * c.nz;
    tx -= tn * c.nx;
    ty -= tn * c.ny;
    tz -= tn * c.nz;

    const double sn = c.sx * c.nx + c.sy * c.ny + c.sz * c.nz;
    const double px = c.sx - sn * c.nx, py = c.sy - sn * c.ny, pz = c.sz - sn * c.nz;
    const double angle = step * c.twist;
    const double qx = px + angle * (c.ny * pz - c.nz * py);
    const double qy = py + angle * (c.nz * px - c.nx * pz);
    const double qz = pz + angle * (c.nx * py - c.ny * px);
    const double before = c.sx * c.sx + c.sy * c.sy + c.sz * c.sz, after = qx * qx + qy * qy + qz * qz;
    const double keep = std::sqrt(before / std::max(after, 1e-280));
    const double sx = keep * qx + step * tx, sy = keep * qy + step * ty, sz = keep * qz + step * tz;

    const double dashpot = tangential_damping * c.root_mass;
    const double gx = -tangential_stiffness * sx - dashpot * tx;
    const double gy = -tangential_stiffness * sy - dashpot * ty;
    const double gz = -tangential_stiffness * sz - dashpot * tz;
    const double limit = friction * normal;
    const double trial = std::sqrt(gx * gx + gy * gy + gz * gz);
    const bool touching = c.overlap > 0.0, sliding = trial > limit;
    const double share = touching ? (sliding ? limit / std::max(trial, 1e-280) : 1.0) : 0.0;
    const double fn = touching ? normal : 0.0;
    const double fx = share * gx, fy = share * gy, fz = share * gz;
    const double stored = -compliance, stick = touching && !sliding ? 1.0 : 0.0, slide = sliding ? stored : 0.0;
    return {fx - fn * c.nx, fy - fn * c.ny, fz - fn * c.nz, stick * sx + slide * fx, stick * sy + slide * fy, stick * sz + slide * fz};
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What every contact law has in common: springs and dashpots along and across the normal, a force that never pulls, Coulomb's slider.
#include <algorithm>
#include <cmath>

namespace physics {

/// Below it a denominator is taken for zero.
inline constexpr double tiny_denominator = 1e-280;

/// One contact before the force is known. Vectors are written out so that loops over contacts become vector code.
struct ContactInput {
    double nx, ny, nz; ///< Unit normal from first to second, at the positions [-].
    double mx, my, mz; ///< Unit normal at the time of the velocities, half a step earlier [-].
    double overlap;    ///< [m]; no contact where it is not positive.
    double vx, vy, vz; ///< Velocity of the first centre against the second [m/s].
    double wx, wy, wz; ///< Spins weighted with the lever arms, first + second [m/s].
    double twist;      ///< Turn of the contact about its normal [1/s].
    double gx, gy,
        gz; ///< What the weighted spins gain where the lever arms were longer, by approach: at a wall its spin, else the mean [1/s].
    double sx, sy, sz; ///< Tangential spring [m].
    double root_mass;  ///< Square root of the reduced mass [kg^1/2].
    double radius;     ///< Reduced radius; at a wall the particle's [m].
    double ux, uy, uz; ///< Spin of the first against the second [1/s].
    double rx, ry, rz; ///< Turn that the springs against rolling and twisting hold [rad].
};

/// Force on the first particle [N] and the new tangential spring [m].
struct ContactOutput {
    double fx, fy, fz;
    double sx, sy, sz;
    double normal; ///< Magnitude of the force that pushes along the normal [N].
};

/// Springs and dashpots of a contact at its present overlap.
struct ContactStiffness {
    double elastic;            ///< Normal force of the spring [N].
    double damping;            ///< Normal dashpot per root of the reduced mass [kg^1/2/s].
    double tangential;         ///< Stiffness across the normal [N/m].
    double compliance;         ///< 1 / tangential [m/N]; 0 if there is none.
    double tangential_damping; ///< Dashpot across the normal per root of the reduced mass.
    double fade;               ///< Share of the old tangential displacement that goes on: what a stiffer spring needs for the same force.
};

/// Velocity of the surfaces against each other across the normal [m/s], and the spring of before, turned with the contact [m].
struct Slip {
    double tx, ty, tz;
    double bx, by, bz;
};

/// The spring follows the turn of the contact at constant length; velocities are taken in the plane of their own time.
[[gnu::always_inline, nodiscard]] inline Slip slip_of(double step, const ContactInput& c, double vn)
{
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
    const double keep = std::sqrt(before / std::max(after, tiny_denominator));
    return {tx, ty, tz, keep * qx, keep * qy, keep * qz};
}

/// The force of a contact; `law.at(contact, normal_speed)` are its springs, `law.friction` Coulomb's coefficient and `law.step` the
/// time step. The tangential spring grows by the slip of the last step. A sliding contact stores the spring that carries the whole
/// friction force and has no tangential dashpot.
template <class Law>
[[gnu::always_inline]] inline ContactOutput contact_force(const Law& law, const ContactInput& c)
{
    const double vn = c.vx * c.mx + c.vy * c.my + c.vz * c.mz;
    const ContactStiffness k = law.at(c, vn);
    const double normal = std::max(0.0, k.elastic + k.damping * c.root_mass * vn);
    const Slip t = slip_of(law.step, c, vn);
    const double sx = k.fade * t.bx + law.step * t.tx, sy = k.fade * t.by + law.step * t.ty, sz = k.fade * t.bz + law.step * t.tz;

    const double dashpot = k.tangential_damping * c.root_mass;
    const double gx = -k.tangential * sx - dashpot * t.tx;
    const double gy = -k.tangential * sy - dashpot * t.ty;
    const double gz = -k.tangential * sz - dashpot * t.tz;
    const double limit = law.friction * normal;
    const double trial = std::sqrt(gx * gx + gy * gy + gz * gz);
    const bool touching = c.overlap > 0.0, sliding = trial > limit;
    const double share = touching ? (sliding ? limit / std::max(trial, tiny_denominator) : 1.0) : 0.0;
    const double fn = touching ? normal : 0.0;
    const double fx = share * gx, fy = share * gy, fz = share * gz;
    const double stored = -k.compliance, stick = touching && !sliding ? 1.0 : 0.0, slide = sliding ? stored : 0.0;
    return {fx - fn * c.nx, fy - fn * c.ny, fz - fn * c.nz, stick * sx + slide * fx, stick * sy + slide * fy, stick * sz + slide * fz, fn};
}

} // namespace physics

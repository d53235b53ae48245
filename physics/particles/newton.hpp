// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Newton's equations for one chunk of particles. A step is half a drift, a kick, half a drift: positions and velocities
// are known at the same times before and after it, forces are taken in its middle.
#include "physics/particles/force_sums.hpp"

namespace physics {

/// Only contacts and a uniform acceleration.
struct DryMotion {
    core::Vec3 gravity = core::Vec3::Zero(); ///< [m/s2]
};

/// Columns that hold a particle's exchange with the fluid during one fluid step.
/// Velocity: v <- keep v + drift + gain F with the contact force F; spin likewise with the contact torque.
struct WetColumns {
    int keep, gain, drift;                ///< drift is the first of three columns.
    int spin_keep, spin_gain, spin_drift; ///< spin_drift is the first of three.
    int impulse;                          ///< First of three: sum of contact force times step [N s].
    int twist;                            ///< First of three: sum of contact torque times step [N m s].
};

/// Contacts, a constant load on each particle, and drag with exact exponential decay.
struct WetMotion {
    WetColumns columns;
};

/// Adds the columns that WetMotion needs.
[[nodiscard]] WetColumns add_wet_columns(core::ParticleSet& particles);

/// What the fluid does to one particle, frozen for one fluid step.
struct WetLoad {
    core::Vec3 force = core::Vec3::Zero();          ///< All but contact and drag; weight included [N].
    core::Vec3 fluid_velocity = core::Vec3::Zero(); ///< [m/s]
    double drag = 0.0;                              ///< Coefficient K: force = K (fluid velocity - velocity) [kg/s].
    double added_mass = 0.0;                        ///< [kg]
    core::Vec3 fluid_spin = core::Vec3::Zero();     ///< Half the vorticity [1/s].
    double spin_drag = 0.0;                         ///< Torque over spin difference [N m s].
};

/// Writes the coefficients of owned particle i for sub-steps of `step` [s]; exact for constant contact force, any drag.
void set_wet_load(core::ParticleSet& particles, const WetColumns& columns, int i, const WetLoad& load, double step);

/// Sets the recorded impulses and angular impulses of contacts to zero.
void clear_impulses(core::ParticleSet& particles, const WetColumns& columns);

/// Kick of the particles of `sums` and a drift of `drift` [s] after it, in two halves: `first_half` now, `second_half`
/// (zero after the last sub-step of a batch) for the next sub-step.
struct DriftTimes {
    double step, first_half, second_half;
};

/// @returns the greatest square of speed after the kick [m2/s2].
double move_chunk(core::ParticleSet& particles, const ForceSums& sums, const DryMotion& motion, const DriftTimes& times);
double move_chunk(core::ParticleSet& particles, const ForceSums& sums, const WetMotion& motion, const DriftTimes& times);

/// Half a drift of all owned particles before the first kick. @returns the greatest square of speed [m2/s2].
double drift_all(core::ParticleSet& particles, double half_step, const core::Team& team);

} // namespace physics

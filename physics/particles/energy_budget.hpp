// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the energy of particles goes: kept for each particle, half of every pair and all of its walls, in scenes that ask for it.
#include "physics/particles/contact_books.hpp"
#include "physics/particles/wall_force.hpp"

namespace physics {

/// Columns of energies [J]: what springs hold at present, what has been dissipated and what walls have given so far.
struct EnergyColumns {
    int elastic = -1, damping = -1, friction = -1, turning = -1, walls = -1;
    [[nodiscard]] bool kept() const { return elastic >= 0; }
};

/// Adds the columns to the particles.
[[nodiscard]] EnergyColumns add_energy_columns(core::ParticleSet& particles);

/// Of the particles of one chunk during one sub-step; entry k belongs to owned particle begin + k.
struct EnergySums {
    using Lane = ForceSums::Lane;
    std::array<Lane, 3> damping, damping_torque; ///< Of dashpots [N], [N m].
    std::array<Lane, 3> resistance;              ///< Torque of what resists turning without a spring [N m].
    Lane elastic, friction, turning;             ///< [J]
    std::array<Lane, 3> velocity, spin;          ///< Before the kick.
    Lane given, given_damping, given_resistance; ///< Power of walls that move: of all forces, of dashpots, of that resistance [W].
};

/// Sums the books of each particle's pairs in the order of its neighbours' ids, and remembers its motion. @pre sums.begin, sums.end
void begin_budget(const core::ParticleSet& particles, const core::PairList& pairs, const core::NearPairs& near, const PairForces& forces,
                  const ForceSums& sums, EnergySums& energy);

/// Adds the book of a wall's contact to particle k of the chunk.
inline void add_wall_book(const ContactBook& book, const WallMeeting& at, std::size_t k, EnergySums& energy)
{
    energy.damping[0][k] += book.fx;
    energy.damping[1][k] += book.fy;
    energy.damping[2][k] += book.fz;
    energy.damping_torque[0][k] += at.depth * (at.ny * book.fz - at.nz * book.fy);
    energy.damping_torque[1][k] += at.depth * (at.nz * book.fx - at.nx * book.fz);
    energy.damping_torque[2][k] += at.depth * (at.nx * book.fy - at.ny * book.fx);
    energy.resistance[0][k] += book.mx;
    energy.resistance[1][k] += book.my;
    energy.resistance[2][k] += book.mz;
    energy.elastic[k] += book.elastic;
    energy.friction[k] += book.friction;
    energy.turning[k] += book.turning;
}

/// Adds the power that a wall that moves gives to particle k of the chunk by the forces `f` of a contact.
/// @param at  With the velocity of the wall at the time of the forces: that of half a step ago would leave an error of first order.
template <class Output>
[[gnu::always_inline]] inline void add_wall_work(const Output& f, const ContactBook& book, const MovingMeeting& at, std::size_t k,
                                                 EnergySums& energy)
{
    energy.given[k] += power_of(f, at);
    energy.given_damping[k] += book.fx * at.ux + book.fy * at.uy + book.fz * at.uz;
    energy.given_resistance[k] += book.mx * at.ox + book.my * at.oy + book.mz * at.oz;
}

/// Books a sub-step after the kick. Works are those of the forces with the mean of the velocities before and after: what the kick gave
/// the particles, exactly. What springs hold is brought from the time of the forces to that of the velocities by their power. At a wall
/// that moves, losses and springs see the velocity against it, and what it gives is booked beside them.
void finish_budget(core::ParticleSet& particles, const EnergyColumns& columns, const ForceSums& sums, const EnergySums& energy,
                   double step);

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The contact of a particle with a wall that does not move, from where they meet to the force.
#include "physics/particles/force_sums.hpp"

namespace physics {

/// Where a particle meets a wall: unit normals from the particle to the wall now and half a step ago, and how far.
struct WallMeeting {
    double nx, ny, nz, mx, my, mz;
    double depth; ///< Distance of the centre from the wall's surface, positive on the side of the particles [m].
};

[[nodiscard]] inline WallMeeting meeting(const core::Vec3& normal, const core::Vec3& normal_before, double depth)
{
    return {normal[0], normal[1], normal[2], normal_before[0], normal_before[1], normal_before[2], depth};
}

/// The input of the contact law of particle i, but for the spring.
inline ContactInput wall_input(const core::ParticleSet& p, std::size_t i, const WallMeeting& at)
{
    ContactInput in;
    in.overlap = p.radius[i] - at.depth;
    in.nx = at.nx;
    in.ny = at.ny;
    in.nz = at.nz;
    in.mx = at.mx;
    in.my = at.my;
    in.mz = at.mz;
    in.vx = p.velocity[0][i];
    in.vy = p.velocity[1][i];
    in.vz = p.velocity[2][i];
    in.wx = at.depth * p.spin[0][i];
    in.wy = at.depth * p.spin[1][i];
    in.wz = at.depth * p.spin[2][i];
    in.twist = 0.5 * (p.spin[0][i] * at.nx + p.spin[1][i] * at.ny + p.spin[2][i] * at.nz);
    in.root_mass = std::sqrt(p.mass[i]);
    return in;
}

/// Adds the force of one contact to the sums of particle k of the chunk.
inline void add_wall_force(const ContactOutput& f, const WallMeeting& at, std::size_t k, ForceSums& sums)
{
    sums.force[0][k] += f.fx;
    sums.force[1][k] += f.fy;
    sums.force[2][k] += f.fz;
    sums.torque[0][k] += at.depth * (at.ny * f.fz - at.nz * f.fy);
    sums.torque[1][k] += at.depth * (at.nz * f.fx - at.nx * f.fz);
    sums.torque[2][k] += at.depth * (at.nx * f.fy - at.ny * f.fx);
}

} // namespace physics

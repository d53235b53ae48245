// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The contact of a particle with a wall, from where they meet to the force.
#include "physics/particles/force_sums.hpp"
#include "physics/particles/wall_frame.hpp"

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

/// Columns of the particles as plain pointers, for vector code.
struct ParticleColumns {
    const double *x, *y, *z, *vx, *vy, *vz, *wx, *wy, *wz, *radius, *mass;
};

struct SumColumns {
    double *fx, *fy, *fz, *tx, *ty, *tz;
};

[[nodiscard]] inline ParticleColumns columns_of(const core::ParticleSet& p)
{
    const auto &x = p.position, &v = p.velocity, &w = p.spin;
    return {x[0].data(), x[1].data(), x[2].data(), v[0].data(),     v[1].data(),  v[2].data(),
            w[0].data(), w[1].data(), w[2].data(), p.radius.data(), p.mass.data()};
}

[[nodiscard]] inline SumColumns columns_of(ForceSums& s)
{
    return {s.force[0].data(), s.force[1].data(), s.force[2].data(), s.torque[0].data(), s.torque[1].data(), s.torque[2].data()};
}

/// The input of the contact law of particle i, but for the spring.
[[gnu::always_inline]] inline ContactInput wall_input(const ParticleColumns& p, std::size_t i, const WallMeeting& at)
{
    ContactInput in;
    in.overlap = p.radius[i] - at.depth;
    in.nx = at.nx;
    in.ny = at.ny;
    in.nz = at.nz;
    in.mx = at.mx;
    in.my = at.my;
    in.mz = at.mz;
    in.vx = p.vx[i];
    in.vy = p.vy[i];
    in.vz = p.vz[i];
    in.wx = at.depth * p.wx[i];
    in.wy = at.depth * p.wy[i];
    in.wz = at.depth * p.wz[i];
    in.gx = p.wx[i];
    in.gy = p.wy[i];
    in.gz = p.wz[i];
    in.twist = 0.5 * (p.wx[i] * at.nx + p.wy[i] * at.ny + p.wz[i] * at.nz);
    in.root_mass = std::sqrt(p.mass[i]);
    in.radius = p.radius[i];
    in.ux = p.wx[i];
    in.uy = p.wy[i];
    in.uz = p.wz[i];
    return in;
}

/// A meeting with a wall that moves: the velocity of its surface there half a step ago [m/s], and its spin [1/s].
struct MovingMeeting : WallMeeting {
    double ux, uy, uz, ox, oy, oz;
};

[[gnu::always_inline]] inline ContactInput wall_input(const ParticleColumns& p, std::size_t i, const MovingMeeting& at)
{
    ContactInput in = wall_input(p, i, static_cast<const WallMeeting&>(at));
    in.vx -= at.ux;
    in.vy -= at.uy;
    in.vz -= at.uz;
    in.ux -= at.ox;
    in.uy -= at.oy;
    in.uz -= at.oz;
    in.gx -= at.ox;
    in.gy -= at.oy;
    in.gz -= at.oz;
    in.twist += 0.5 * (at.ox * at.nx + at.oy * at.ny + at.oz * at.nz);
    return in;
}

/// How the points of a moving wall move.
struct WallVelocity {
    double vx, vy, vz, ox, oy, oz; ///< Velocity of the wall's point at the origin [m/s]; spin [rad/s].

    explicit WallVelocity(const WallPose& pose)
    {
        const core::Vec3 v = pose.velocity_at(core::Vec3::Zero());
        vx = v[0];
        vy = v[1];
        vz = v[2];
        ox = pose.spin[0];
        oy = pose.spin[1];
        oz = pose.spin[2];
    }
    /// @param x,y,z  The centre half a step ago [m].
    [[gnu::always_inline]] MovingMeeting operator()(const WallMeeting& at, double x, double y, double z) const
    {
        return moving(at, x + at.depth * at.mx, y + at.depth * at.my, z + at.depth * at.mz);
    }
    /// The same where the particle is now, if the wall moves like this now. @param x,y,z  The centre [m].
    [[gnu::always_inline]] MovingMeeting present(const WallMeeting& at, double x, double y, double z) const
    {
        return moving(at, x + at.depth * at.nx, y + at.depth * at.ny, z + at.depth * at.nz);
    }

private:
    [[gnu::always_inline]] MovingMeeting moving(const WallMeeting& at, double cx, double cy, double cz) const
    {
        return {at, vx + (oy * cz - oz * cy), vy + (oz * cx - ox * cz), vz + (ox * cy - oy * cx), ox, oy, oz};
    }
};

/// Power that a wall gives to a particle [W].
[[gnu::always_inline]] inline double power_of(const ContactOutput& f, const MovingMeeting& at)
{
    return f.fx * at.ux + f.fy * at.uy + f.fz * at.uz;
}

/// The same with the torque against turning.
[[gnu::always_inline]] inline double power_of(const GeneralOutput& f, const MovingMeeting& at)
{
    return power_of(static_cast<const ContactOutput&>(f), at) + f.mx * at.ox + f.my * at.oy + f.mz * at.oz;
}

/// Adds the force of one contact to the sums of particle k of the chunk.
[[gnu::always_inline]] inline void add_wall_force(const ContactOutput& f, const WallMeeting& at, std::size_t k, const SumColumns& sums)
{
    sums.fx[k] += f.fx;
    sums.fy[k] += f.fy;
    sums.fz[k] += f.fz;
    sums.tx[k] += at.depth * (at.ny * f.fz - at.nz * f.fy);
    sums.ty[k] += at.depth * (at.nz * f.fx - at.nx * f.fz);
    sums.tz[k] += at.depth * (at.nx * f.fy - at.ny * f.fx);
}

/// The same with the torque against turning.
[[gnu::always_inline]] inline void add_wall_force(const GeneralOutput& f, const WallMeeting& at, std::size_t k, const SumColumns& sums)
{
    add_wall_force(static_cast<const ContactOutput&>(f), at, k, sums);
    sums.tx[k] += f.mx;
    sums.ty[k] += f.my;
    sums.tz[k] += f.mz;
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where particles meet planes and cylinders, at rest or on their way, for vector code.
#include "physics/particles/wall_force.hpp"
#include "physics/particles/walls.hpp"

namespace physics {

/// meet(x, y, z, hx, hy, hz): a centre and its way of the last half step [m].
struct PlaneMeeting {
    static constexpr bool moves = false;
    double px, py, pz, nx, ny, nz;
    explicit PlaneMeeting(const PlaneWall& w)
        : px(w.point[0]), py(w.point[1]), pz(w.point[2]), nx(-w.normal[0]), ny(-w.normal[1]), nz(-w.normal[2])
    {
    }
    [[gnu::always_inline]] WallMeeting operator()(double x, double y, double z, double, double, double) const
    {
        return {nx, ny, nz, nx, ny, nz, (px - x) * nx + (py - y) * ny + (pz - z) * nz};
    }
};

struct CylinderMeeting {
    static constexpr bool moves = false;
    double px, py, pz, ax, ay, az, radius, outward;
    explicit CylinderMeeting(const CylinderWall& w)
        : px(w.point[0]),
          py(w.point[1]),
          pz(w.point[2]),
          ax(w.axis[0]),
          ay(w.axis[1]),
          az(w.axis[2]),
          radius(w.radius),
          outward(w.particles == WallSide::inside ? 1.0 : -1.0)
    {
    }
    [[gnu::always_inline]] WallMeeting operator()(double x, double y, double z, double hx, double hy, double hz) const
    {
        const double dx = x - px, dy = y - py, dz = z - pz;
        const double along = dx * ax + dy * ay + dz * az, h_along = hx * ax + hy * ay + hz * az;
        const double rx = dx - along * ax, ry = dy - along * ay, rz = dz - along * az;
        const double bx = rx - (hx - h_along * ax), by = ry - (hy - h_along * ay), bz = rz - (hz - h_along * az);
        const double distance = std::sqrt(rx * rx + ry * ry + rz * rz);
        const double tiny = 1e-12 * radius; // on the axis any direction is as good
        const double r = outward / std::max(distance, tiny), b = outward / std::max(std::sqrt(bx * bx + by * by + bz * bz), tiny);
        return {rx * r, ry * r, rz * r, bx * b, by * b, bz * b, outward * (radius - distance)};
    }
};

[[nodiscard]] inline PlaneMeeting meeting_of(const PlaneWall& w) { return PlaneMeeting(w); }
[[nodiscard]] inline CylinderMeeting meeting_of(const CylinderWall& w) { return CylinderMeeting(w); }

/// A wall that moves or is reported: its normal and the velocity of its surface half a step ago are those where the particle was then.
template <class Meeting>
struct MovedMeeting {
    static constexpr bool moves = true;
    Meeting now, before;
    WallVelocity velocity, velocity_now;

    MovedMeeting(const Meeting& now_, const Meeting& before_, const WallFrame& frame)
        : now(now_), before(before_), velocity(frame.before()), velocity_now(frame.now())
    {
    }
    [[gnu::always_inline]] MovingMeeting operator()(double x, double y, double z, double hx, double hy, double hz) const
    {
        const double ex = x - hx, ey = y - hy, ez = z - hz;
        const WallMeeting at = now(x, y, z, 0.0, 0.0, 0.0), earlier = before(ex, ey, ez, 0.0, 0.0, 0.0);
        return velocity({at.nx, at.ny, at.nz, earlier.nx, earlier.ny, earlier.nz, at.depth}, ex, ey, ez);
    }
    /// The same with the wall's velocity of now.
    [[gnu::always_inline]] MovingMeeting present(double x, double y, double z, const WallMeeting& at) const
    {
        return velocity_now.present(at, x, y, z);
    }
};

} // namespace physics

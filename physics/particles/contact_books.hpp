// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The energy of one contact: what its springs hold, what slip and yielding took in the last step, and which forces damp.
#include "physics/particles/lubrication.hpp"

namespace physics {

/// Energies in J; forces and torques act on the first particle.
struct ContactBook {
    double elastic;    ///< Held by all springs; what cohesion has given counts negative.
    double friction;   ///< Taken since the last step by slip, and by springs across the normal that soften or open.
    double turning;    ///< Taken since the last step by springs against rolling and twisting that yield.
    double fx, fy, fz; ///< Of dashpots along and across the normal [N].
    double mx, my, mz; ///< Of what resists turning without a spring [N m].
};

/// The energy of a normal spring [J], and the stiffness across the normal before the last step [N/m].
struct SpringState {
    double energy, tangential_before;
};

[[gnu::always_inline, nodiscard]] inline SpringState spring_state(const LinearContact& law, const ContactInput& c, double)
{
    return {0.5 * law.stiffness * c.overlap * c.overlap, law.tangential_stiffness};
}

/// The integral of 4/3 E sqrt(R) delta^(3/2) is 2/5 of force times overlap.
[[gnu::always_inline, nodiscard]] inline SpringState spring_state(const HertzContact& law, const ContactInput& c, double normal_speed)
{
    const double overlap = std::max(0.0, c.overlap), before = std::max(0.0, c.overlap - law.step * normal_speed);
    return {0.4 * law.modulus * std::sqrt(c.radius * overlap) * overlap * overlap, law.tangential_modulus * std::sqrt(c.radius * before)};
}

[[gnu::always_inline, nodiscard]] inline SpringState spring_state(const GeneralContact& law, const ContactInput& c, double normal_speed)
{
    const SpringState a = spring_state(law.linear, c, normal_speed), b = spring_state(law.hertz, c, normal_speed);
    return {a.energy + b.energy - law.pull * c.radius * c.overlap, a.tangential_before + b.tangential_before};
}

/// What a spring that held `before` and holds `after` took of the way or turn `step`: the work on it, at the mean of its forces before
/// and after, less what it stores.
/// @param k0,k1  Its stiffness before and after.
[[gnu::always_inline, nodiscard]] inline double spring_loss(double k0, double k1, double work0, double work1, double before2, double after2)
{
    return 0.5 * (k0 * work0 + k1 * work1) + 0.5 * (k0 * before2 - k1 * after2);
}

/// Adds the springs against rolling and twisting.
[[gnu::always_inline]] inline void book_turning(const GeneralContact& law, const ContactInput& c, const GeneralOutput& out, double vn,
                                                ContactBook& book)
{
    const double touching = c.overlap > 0.0 ? 1.0 : 0.0, before = c.overlap - law.step * vn;
    const double roll0 = law.resistance(c, before, law.rolling, 0.0).stiffness,
                 roll1 = law.resistance(c, c.overlap, law.rolling, 0.0).stiffness;
    const double twist0 = law.resistance(c, before, law.twisting, 0.0).stiffness,
                 twist1 = law.resistance(c, c.overlap, law.twisting, 0.0).stiffness;
    const HeldTurn held = held_turn(law.step, c);
    const double twist = out.rx * c.nx + out.ry * c.ny + out.rz * c.nz, un = law.step * (c.ux * c.nx + c.uy * c.ny + c.uz * c.nz);
    const double rx = out.rx - twist * c.nx, ry = out.ry - twist * c.ny, rz = out.rz - twist * c.nz;
    const double ux = law.step * c.ux, uy = law.step * c.uy, uz = law.step * c.uz; // what is along the normal meets nothing
    const double held2 = held.x * held.x + held.y * held.y + held.z * held.z, after2 = rx * rx + ry * ry + rz * rz;
    book.elastic += touching * 0.5 * (roll1 * after2 + twist1 * twist * twist);
    book.turning = spring_loss(roll0, roll1, ux * held.x + uy * held.y + uz * held.z, ux * rx + uy * ry + uz * rz, held2, after2) +
                   spring_loss(twist0, twist1, un * held.twist, un * twist, held.twist * held.twist, twist * twist);
    book.mx = out.mx + roll1 * rx + twist1 * twist * c.nx;
    book.my = out.my + roll1 * ry + twist1 * twist * c.ny;
    book.mz = out.mz + roll1 * rz + twist1 * twist * c.nz;
}

/// The book of a contact that went from `in` to `out`. Velocities belong to the time between the forces before and after, so that
/// works and stored energies add up exactly for springs of constant stiffness.
template <class Law, class Output>
[[gnu::always_inline, nodiscard]] inline ContactBook contact_book(const Law& law, const ContactInput& c, const Output& out)
{
    const double vn = c.vx * c.mx + c.vy * c.my + c.vz * c.mz;
    const ContactStiffness k = law.at(c, vn);
    const SpringState spring = spring_state(law, c, vn);
    const double touching = c.overlap > 0.0 ? 1.0 : 0.0;
    const Slip slip = slip_of(law.step, c, vn);
    const double sx = slip.bx, sy = slip.by, sz = slip.bz, tx = law.step * slip.tx, ty = law.step * slip.ty, tz = law.step * slip.tz;
    // the force of before worked at the lever arms of before
    const double more = law.step * law.step * vn;
    const double ex = tx + more * (c.gy * c.mz - c.gz * c.my), ey = ty + more * (c.gz * c.mx - c.gx * c.mz),
                 ez = tz + more * (c.gx * c.my - c.gy * c.mx);
    const double before2 = sx * sx + sy * sy + sz * sz, after2 = out.sx * out.sx + out.sy * out.sy + out.sz * out.sz;
    ContactBook book;
    book.elastic = touching * (spring.energy + 0.5 * k.tangential * after2);
    book.friction = spring_loss(spring.tangential_before, k.tangential, ex * sx + ey * sy + ez * sz,
                                tx * out.sx + ty * out.sy + tz * out.sz, before2, touching * after2);
    // along the normal what is not the spring; across it what is not the spring, in the plane of the contact
    const double damping = touching * (out.normal - k.elastic), fn = out.fx * c.nx + out.fy * c.ny + out.fz * c.nz;
    const double spring_x = touching * k.tangential * out.sx, spring_y = touching * k.tangential * out.sy,
                 spring_z = touching * k.tangential * out.sz;
    book.fx = out.fx - fn * c.nx + spring_x - damping * c.nx;
    book.fy = out.fy - fn * c.ny + spring_y - damping * c.ny;
    book.fz = out.fz - fn * c.nz + spring_z - damping * c.nz;
    book.turning = book.mx = book.my = book.mz = 0.0;
    if constexpr (Law::resists_turning) book_turning(law, c, out, vn, book);
    if constexpr (std::is_same_v<Law, LubricatedContact>) {
        const double push = law.film_force(c);
        book.fx -= push * c.nx;
        book.fy -= push * c.ny;
        book.fz -= push * c.nz;
    }
    return book;
}

} // namespace physics

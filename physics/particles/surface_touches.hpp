// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Places where particles touch a surface, some at a time, for vector code.
#include "physics/particles/wall_sums.hpp"

namespace physics {

struct alignas(64) SurfaceTouches {
    static constexpr int size = 32;
    using Lane = double[size];
    int particle[size], law[size];      ///< Who touches, and its place among the laws.
    Lane nx, ny, nz, mx, my, mz, depth; ///< As in WallMeeting.
    Lane spring[core::rolling_memory];  ///< Springs, before and after.
    Lane fx, fy, fz;                    ///< Forces [N].
    Lane tx, ty, tz;                    ///< Torques against turning [N m].
    bool turning = false;               ///< True if contacts resist turning.
    ContactBook books[size];            ///< Where a budget is kept.
    int count = 0;

    /// Normals from the surface to the particle, now and half a step ago; how far the surface is from the centre [m].
    struct Where {
        core::Vec3 normal, before;
        double depth;
    };
    void add(int i, int law_of_it, const Where& at, const core::Spring& before_spring)
    {
        const int k = count++;
        particle[k] = i;
        law[k] = law_of_it;
        nx[k] = -at.normal[0];
        ny[k] = -at.normal[1];
        nz[k] = -at.normal[2];
        mx[k] = -at.before[0];
        my[k] = -at.before[1];
        mz[k] = -at.before[2];
        depth[k] = at.depth;
        for (std::size_t a = 0; a < before_spring.size(); ++a) spring[a][k] = before_spring[a];
    }
    [[nodiscard]] core::Vec3 normal(int k) const { return {nx[k], ny[k], nz[k]}; }
    [[nodiscard]] core::Vec3 tangential(int k) const { return {spring[0][k], spring[1][k], spring[2][k]}; }
    [[nodiscard]] core::Vec3 turn(int k) const { return {spring[3][k], spring[4][k], spring[5][k]}; }
    [[nodiscard]] core::Vec3 force(int k) const { return {fx[k], fy[k], fz[k]}; }
    [[nodiscard]] core::Vec3 couple(int k) const { return turning ? core::Vec3(tx[k], ty[k], tz[k]) : core::Vec3(core::Vec3::Zero()); }
    [[nodiscard]] WallMeeting at(int k) const { return {nx[k], ny[k], nz[k], mx[k], my[k], mz[k], depth[k]}; }

    /// Forces; moves the springs one step on. law_of(k) is the law of contact k.
    template <Budget budget, class LawOf>
    void evaluate(const ParticleColumns& columns, LawOf law_of)
    {
        evaluate_at<budget>(columns, law_of, [this](int k, double) { return at(k); });
    }
    /// The same with a wall that moves.
    template <Budget budget, class LawOf>
    void evaluate_moving(const ParticleColumns& columns, LawOf law_of, const WallVelocity& velocity)
    {
        evaluate_at<budget>(columns, law_of,
                            [this, &columns, velocity](int k, double half_step) { return meeting(columns, k, half_step, velocity); });
    }
    [[gnu::always_inline]] MovingMeeting meeting(const ParticleColumns& p, int k, double half_step, const WallVelocity& velocity) const
    {
        const auto i = std::size_t(particle[k]);
        return velocity(at(k), p.x[i] - half_step * p.vx[i], p.y[i] - half_step * p.vy[i], p.z[i] - half_step * p.vz[i]);
    }

    /// Adds the forces to the sums of a chunk whose first particle is `first`, one after the other.
    void add_to(const SumColumns& sums, std::size_t first) const
    {
        for (int k = 0; k < count; ++k) {
            const GeneralOutput out{{fx[k], fy[k], fz[k], 0.0, 0.0, 0.0, 0.0}, tx[k], ty[k], tz[k], 0.0, 0.0, 0.0};
            if (turning) add_wall_force(out, at(k), std::size_t(particle[k]) - first, sums);
            else add_wall_force(static_cast<const ContactOutput&>(out), at(k), std::size_t(particle[k]) - first, sums);
        }
    }

    /// Adds the contacts to what is measured.
    void measure(const core::Column& radius, std::size_t first, WallShares& shares) const
    {
        for (int k = 0; k < count; ++k) {
            const auto i = std::size_t(particle[k]);
            shares.add(i - first, force(k), depth[k] * normal(k), radius[i]);
        }
    }

    /// Adds the books likewise. @param velocity  Of the wall now.
    void add_books(const ParticleColumns& p, std::size_t first, const WallVelocity& velocity, EnergySums& energy) const
    {
        for (int k = 0; k < count; ++k) {
            const auto i = std::size_t(particle[k]);
            const GeneralOutput out{{fx[k], fy[k], fz[k], 0.0, 0.0, 0.0, 0.0}, couple(k)[0], couple(k)[1], couple(k)[2], 0.0, 0.0, 0.0};
            add_wall_book(books[k], at(k), i - first, energy);
            add_wall_work(out, books[k], velocity.present(at(k), p.x[i], p.y[i], p.z[i]), i - first, energy);
        }
    }

private:
    /// meeting_at(k, half a step) is where contact k is.
    template <Budget budget, class LawOf, class MeetingAt>
    [[gnu::always_inline]] void evaluate_at(const ParticleColumns& columns, LawOf law_of, MeetingAt meeting_at)
    {
        using Law = std::decay_t<decltype(law_of(0))>;
        const SpringColumns springs{spring[0], spring[1], spring[2], spring[3], spring[4], spring[5]};
        turning = Law::resists_turning;
#pragma omp simd
        for (int k = 0; k < count; ++k) {
            const auto i = std::size_t(particle[k]);
            const Law& its = law_of(k);
            ContactInput in = wall_input(columns, i, meeting_at(k, 0.5 * its.step));
            const auto out = move_springs(its, in, springs, k);
            if constexpr (budget == Budget::kept) books[k] = contact_book(its, in, out);
            fx[k] = out.fx;
            fy[k] = out.fy;
            fz[k] = out.fz;
            if constexpr (Law::resists_turning) {
                tx[k] = out.mx;
                ty[k] = out.my;
                tz[k] = out.mz;
            }
        }
    }
};

} // namespace physics

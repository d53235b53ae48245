// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Places where particles touch a surface, some at a time, for vector code.
#include "physics/particles/wall_force.hpp"

namespace physics {

struct alignas(64) SurfaceTouches {
    static constexpr int size = 32;
    using Lane = double[size];
    int particle[size];
    Lane nx, ny, nz, mx, my, mz, depth; ///< As in WallMeeting.
    Lane sx, sy, sz;                    ///< Tangential springs, before and after.
    Lane fx, fy, fz;                    ///< Forces [N].
    int count = 0;

    /// @param normal,before  From the surface to the particle, now and half a step ago.
    void add(int i, const core::Vec3& normal, const core::Vec3& before, double depth_there, const core::Vec3& spring)
    {
        const int k = count++;
        particle[k] = i;
        nx[k] = -normal[0];
        ny[k] = -normal[1];
        nz[k] = -normal[2];
        mx[k] = -before[0];
        my[k] = -before[1];
        mz[k] = -before[2];
        depth[k] = depth_there;
        sx[k] = spring[0];
        sy[k] = spring[1];
        sz[k] = spring[2];
    }
    [[nodiscard]] core::Vec3 normal(int k) const { return {nx[k], ny[k], nz[k]}; }
    [[nodiscard]] core::Vec3 spring(int k) const { return {sx[k], sy[k], sz[k]}; }
    [[nodiscard]] WallMeeting at(int k) const { return {nx[k], ny[k], nz[k], mx[k], my[k], mz[k], depth[k]}; }

    /// Forces; moves the springs one step on. law_of(i) is the law of particle i.
    template <class LawOf>
    void evaluate(const ParticleColumns& columns, LawOf law_of)
    {
#pragma omp simd
        for (int k = 0; k < count; ++k) {
            const auto i = std::size_t(particle[k]);
            const LinearContact& law = law_of(i);
            ContactInput in = wall_input(columns, i, at(k));
            in.sx = sx[k];
            in.sy = sy[k];
            in.sz = sz[k];
            const ContactOutput out = law(in);
            sx[k] = out.sx;
            sy[k] = out.sy;
            sz[k] = out.sz;
            fx[k] = out.fx;
            fy[k] = out.fy;
            fz[k] = out.fz;
        }
    }

    /// Adds the forces to the sums of a chunk whose first particle is `first`, one after the other.
    void add_to(const SumColumns& sums, std::size_t first) const
    {
        for (int k = 0; k < count; ++k) add_wall_force({fx[k], fy[k], fz[k], 0.0, 0.0, 0.0}, at(k), std::size_t(particle[k]) - first, sums);
    }
};

} // namespace physics

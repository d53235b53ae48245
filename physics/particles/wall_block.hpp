// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Contacts with a plane or a cylinder, some at a time: what particles bring to them, and what comes out, side by side for vector code.
#include "core/base/eight.hpp"
#include "physics/particles/motion_records.hpp"
#include "physics/particles/wall_meeting.hpp"
#include "physics/particles/wall_sums.hpp"

namespace physics {

/// The contacts [begin, end) of one wall: particles, no two alike, and springs.
struct WallColumns {
    const int* particle;
    std::vector<core::Column>& spring;
    int begin, end;
};

/// What is noted of the contacts of one chunk with a wall that is reported.
struct ContactNotes {
    using Lane = std::array<double, core::particles_per_chunk>;
    std::array<Lane, 3> force, couple, place;
    Lane power;

    /// @param x,y,z  Centre of the particle [m].
    template <class Output>
    [[gnu::always_inline]] void take(std::size_t k, double x, double y, double z, const MovingMeeting& at, const Output& f)
    {
        force[0][k] = f.fx;
        force[1][k] = f.fy;
        force[2][k] = f.fz;
        if constexpr (std::is_same_v<Output, GeneralOutput>) {
            couple[0][k] = f.mx;
            couple[1][k] = f.my;
            couple[2][k] = f.mz;
        } else couple[0][k] = couple[1][k] = couple[2][k] = 0.0;
        place[0][k] = x + at.depth * at.nx;
        place[1][k] = y + at.depth * at.ny;
        place[2][k] = z + at.depth * at.nz;
        power[k] = power_of(f, at);
    }
    void add_to(WallLoad& load, int count, const core::Vec3& reference) const
    {
        const auto at = [](const std::array<Lane, 3>& lanes, std::size_t k) { return core::Vec3(lanes[0][k], lanes[1][k], lanes[2][k]); };
        for (std::size_t k = 0; k < std::size_t(count); ++k)
            if (const core::Vec3 push = at(force, k); !push.isZero(0.0))
                load.add({push, at(couple, k), at(place, k) - reference, power[k]});
    }
};

/// Of a wall that is neither reported nor moves.
struct NoNotes {
    template <class Output>
    [[gnu::always_inline]] void take(std::size_t, double, double, double, const WallMeeting&, const Output&)
    {
    }
};

/// Places up to the next multiple of eight repeat the last contact.
struct alignas(64) WallBlock {
    static constexpr int size = 64, width = 8;
    using Lane = double[size];
    int particle[size];
    Lane x, y, z, light, vx, vy, vz, wx, wy, wz, radius, mass; ///< As in MotionRecords.
    Lane spring[core::rolling_memory];
    Lane fx, fy, fz, tx, ty, tz;
    int count = 0;

    static constexpr int whole(int n) { return (n + width - 1) / width * width; }

    void read(const MotionRecords::View& records, const WallColumns& wall, int begin)
    {
        count = std::min(size, wall.end - begin);
        for (int k = 0; k < whole(count); ++k) particle[k] = wall.particle[begin + std::min(k, count - 1)];
        for (int k = 0; k < count; k += width) {
            core::Eight motion[width];
            core::Four spin[width];
            for (int lane = 0; lane < width; ++lane) {
                const auto& record = records[particle[k + lane]];
                motion[lane] = core::load_eight(record.motion);
                spin[lane] = core::load_four(record.spin);
            }
            core::transpose(motion);
            double* const to_motion[] = {x, y, z, light, vx, vy, vz};
            for (int n = 0; n < 7; ++n) core::store_eight(to_motion[n] + k, motion[n]);
            for (int half = 0; half < width; half += 4) {
                core::transpose(spin[half], spin[half + 1], spin[half + 2], spin[half + 3]);
                double* const to_spin[] = {wx, wy, wz, radius};
                for (int n = 0; n < 4; ++n) core::store_four(to_spin[n] + k + half, spin[half + n]);
            }
        }
        for (std::size_t a = 0; a < wall.spring.size(); ++a)
            for (int k = 0; k < whole(count); ++k) spring[a][k] = k < count ? wall.spring[a][std::size_t(begin + k)] : 0.0;
    }
    /// Springs go back to their columns, forces to the sums of the particles.
    void write(const WallColumns& wall, int begin, ForceSums& sums) const
    {
        for (std::size_t a = 0; a < wall.spring.size(); ++a) std::copy_n(spring[a], count, wall.spring[a].begin() + begin);
        const SumColumns to = columns_of(sums);
        for (int k = 0; k < count; ++k) {
            const int i = particle[k] - sums.begin;
            to.fx[i] += fx[k];
            to.fy[i] += fy[k];
            to.fz[i] += fz[k];
            to.tx[i] += tx[k];
            to.ty[i] += ty[k];
            to.tz[i] += tz[k];
        }
    }
};

/// Forces of the contacts in the block; moves their springs. @param noted  The place of the first among the notes.
template <Budget budget, class Meet, class Law, class Notes>
void evaluate_wall(WallBlock& b, const Meet meet, const Law law, const WallSums& sums, Notes& notes, int noted)
{
    const ParticleColumns columns{b.x, b.y, b.z, b.vx, b.vy, b.vz, b.wx, b.wy, b.wz, b.radius, b.mass};
    const SpringColumns springs{b.spring[0], b.spring[1], b.spring[2], b.spring[3], b.spring[4], b.spring[5]};
    const SumColumns add{b.fx, b.fy, b.fz, b.tx, b.ty, b.tz};
    const auto first = sums.particles.begin;
    const int end = budget == Budget::kept || Meet::moves ? b.count : WallBlock::whole(b.count);
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        b.mass[k] = 1.0 / b.light[k];
        b.fx[k] = b.fy[k] = b.fz[k] = b.tx[k] = b.ty[k] = b.tz[k] = 0.0;
        const double half = 0.5 * law.step, x = b.x[k], y = b.y[k], z = b.z[k];
        const auto at = meet(x, y, z, half * b.vx[k], half * b.vy[k], half * b.vz[k]);
        ContactInput in = wall_input(columns, std::size_t(k), at);
        const auto out = move_springs(law, in, springs, k);
        add_wall_force(out, at, std::size_t(k), add);
        notes.take(std::size_t(noted + k), x, y, z, at, out);
        if constexpr (budget == Budget::kept) {
            const auto i = std::size_t(b.particle[k] - first);
            const ContactBook book = contact_book(law, in, out);
            add_wall_book(book, at, i, *sums.energy);
            if constexpr (Meet::moves) add_wall_work(out, book, meet.present(x, y, z, at), i, *sums.energy);
        }
    }
}

/// Adds the contacts in the block to what is measured. @param step  [s]
template <class Meet>
void measure_wall(const WallBlock& b, const Meet& meet, double step, int first, WallShares& shares)
{
    const double half = 0.5 * step;
    for (int k = 0; k < b.count; ++k) {
        const auto at = meet(b.x[k], b.y[k], b.z[k], half * b.vx[k], half * b.vy[k], half * b.vz[k]);
        shares.add(std::size_t(b.particle[k] - first), {b.fx[k], b.fy[k], b.fz[k]}, at.depth * core::Vec3(at.nx, at.ny, at.nz),
                   b.radius[k]);
    }
}

/// The contacts of particles whose law with the wall is `law`. @param noted  As in evaluate_wall().
template <class Meet, class Law, class Notes>
void run_contacts(const MotionRecords::View& records, const WallColumns& wall, const Meet& meet, const Law& law, const WallSums& sums,
                  Notes& notes, int noted)
{
    WallBlock block;
    for (int begin = wall.begin; begin < wall.end; begin += WallBlock::size) {
        block.read(records, wall, begin);
        const int place = noted + begin - wall.begin;
        if (sums.energy) evaluate_wall<Budget::kept>(block, meet, law, sums, notes, place);
        else evaluate_wall<Budget::none>(block, meet, law, sums, notes, place);
        if (sums.shares) measure_wall(block, meet, law.step, sums.particles.begin, *sums.shares);
        block.write(wall, begin, sums.particles);
    }
}

} // namespace physics

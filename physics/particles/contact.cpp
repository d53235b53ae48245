// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact.hpp"
#include "core/base/eight.hpp"
#include "core/base/error.hpp"
#include "core/base/random.hpp"

#include <cstring>
#include <limits>
#include <numbers>

namespace physics {
namespace {

/// Centres closer than this share of the sum of their radii have no direction of their own.
constexpr double coincident_share = 1e-10;

/// The near pairs' columns that a force reads and moves.
struct PairColumns {
    const int *first, *second;
    double* spring;  ///< Of the chunk's first pair; those of the next column are `near` further on.
    int begin, near; ///< The chunk's first pair, and how many are near.
    int width;       ///< Columns of springs.
    ContactForce* forces;
    ContactCouple* couples;
    PairBook* books;       ///< Null where no budget is kept.
    std::ptrdiff_t offset; ///< From near pairs to their slots.
};

/// What the particles of some consecutive pairs bring together, and what comes out: small enough for the innermost cache.
struct alignas(64) PairBlock {
    static constexpr int size = 64;
    using Lane = double[size];
    Lane dx, dy, dz, vx, vy, vz;                ///< Second centre from the first; velocity of the second against the first.
    Lane ri, rj, ax, ay, az, bx, by, bz, light; ///< Radii and spins; the sum of both 1 / mass.
    Lane sx, sy, sz, rx, ry, rz;                ///< Springs.
    Lane fx, fy, fz, tx, ty, tz, li, lj;        ///< Force, normal x force, lever arms.
    Lane mx, my, mz;                            ///< Torque against turning.
};

/// Eight pairs are worked on together.
constexpr int width = 8;
constexpr int whole(int count) { return (count + width - 1) / width * width; }

/// Changes the signs of all but 1 / mass, which is the sum of both while all others are differences.
core::Eight turned(const core::Eight& motion)
{
    using Bits = std::int64_t __attribute__((vector_size(64)));
    constexpr std::int64_t sign = std::numeric_limits<std::int64_t>::min();
    constexpr Bits signs = {sign, sign, sign, 0, sign, sign, sign, sign};
    return core::Eight(Bits(motion) ^ signs);
}

/// Reads pairs [begin, begin + count); the places up to the next multiple of eight repeat the last one.
/// @param move  move(m, d): the difference d of the pair's places and velocities, shifted to the image that it meets.
template <class Move>
void read_block(const MotionRecords::View& records, const PairColumns& pair, int begin, int count, Move move, PairBlock& b)
{
    using core::Eight, core::load_four, core::store_eight;
    for (int k = 0; k < count; k += width) {
        Eight d[width], w[width];
        for (int lane = 0; lane < width; ++lane) {
            const int m = begin + std::min(k + lane, count - 1);
            const auto &first = records[pair.first[m]], &second = records[pair.second[m]];
            d[lane] = move(m, core::load_eight(second.motion) + turned(core::load_eight(first.motion)));
            w[lane] = core::join(load_four(first.spin), load_four(second.spin));
        }
        core::transpose(d);
        core::transpose(w);
        double *const to_d[] = {b.dx, b.dy, b.dz, b.light, b.vx, b.vy, b.vz}, *const to_w[] = {b.ax, b.ay, b.az, b.ri,
                                                                                               b.bx, b.by, b.bz, b.rj};
        for (int n = 0; n < 7; ++n) store_eight(to_d[n] + k, d[n]);
        for (int n = 0; n < 8; ++n) store_eight(to_w[n] + k, w[n]);
    }
}

/// Springs of pairs from `begin` on into the block, or back.
template <class Copy>
void for_each_spring(const PairColumns& pair, int begin, PairBlock& b, Copy copy)
{
    double* const lanes[] = {b.sx, b.sy, b.sz, b.rx, b.ry, b.rz};
    for (int a = 0; a < pair.width; ++a) copy(pair.spring + a * pair.near + (begin - pair.begin), lanes[a]);
}

/// Gives pairs whose centres coincide a direction from their ids, and no spring.
void separate(const PairScene& scene, const PairColumns& pair, int begin, int count, PairBlock& b);

[[gnu::always_inline]] inline PairBook pair_book(const ContactBook& book, const ContactInput& in)
{
    return {book, {in.ny * book.fz - in.nz * book.fy, in.nz * book.fx - in.nx * book.fz, in.nx * book.fy - in.ny * book.fx}};
}

/// Forces of the pairs in the block, up to a multiple of eight unless a budget is kept; moves their springs.
template <Budget budget, class Law>
void evaluate_block(const Law law, int count, PairBlock& b, PairBook* books)
{
    const SpringColumns springs{b.sx, b.sy, b.sz, b.rx, b.ry, b.rz};
    const int end = budget == Budget::kept ? count : whole(count);
#pragma omp simd
    for (int k = 0; k < end; ++k) {
        const double dx = b.dx[k], dy = b.dy[k], dz = b.dz[k];
        const double distance = std::sqrt(dx * dx + dy * dy + dz * dz), inverse = 1.0 / distance;
        ContactInput in;
        in.overlap = b.ri[k] + b.rj[k] - distance;
        in.nx = dx * inverse;
        in.ny = dy * inverse;
        in.nz = dz * inverse;
        in.vx = -b.vx[k];
        in.vy = -b.vy[k];
        in.vz = -b.vz[k];
        const double vn = in.vx * in.nx + in.vy * in.ny + in.vz * in.nz, back = 0.5 * law.step * inverse;
        in.mx = in.nx + back * (in.vx - vn * in.nx);
        in.my = in.ny + back * (in.vy - vn * in.ny);
        in.mz = in.nz + back * (in.vz - vn * in.nz);
        const double li = b.ri[k] - 0.5 * in.overlap, lj = b.rj[k] - 0.5 * in.overlap;
        in.wx = li * b.ax[k] + lj * b.bx[k];
        in.wy = li * b.ay[k] + lj * b.by[k];
        in.wz = li * b.az[k] + lj * b.bz[k];
        in.gx = 0.5 * (b.ax[k] + b.bx[k]);
        in.gy = 0.5 * (b.ay[k] + b.by[k]);
        in.gz = 0.5 * (b.az[k] + b.bz[k]);
        in.twist = 0.5 * ((b.ax[k] + b.bx[k]) * in.nx + (b.ay[k] + b.by[k]) * in.ny + (b.az[k] + b.bz[k]) * in.nz);
        in.root_mass = std::sqrt(1.0 / b.light[k]);
        in.radius = b.ri[k] * b.rj[k] / (b.ri[k] + b.rj[k]);
        in.ux = b.ax[k] - b.bx[k];
        in.uy = b.ay[k] - b.by[k];
        in.uz = b.az[k] - b.bz[k];
        const auto out = move_springs(law, in, springs, k);
        if constexpr (budget == Budget::kept) books[k] = pair_book(contact_book(law, in, out), in);
        b.fx[k] = out.fx;
        b.fy[k] = out.fy;
        b.fz[k] = out.fz;
        b.tx[k] = in.ny * out.fz - in.nz * out.fy;
        b.ty[k] = in.nz * out.fx - in.nx * out.fz;
        b.tz[k] = in.nx * out.fy - in.ny * out.fx;
        b.li[k] = li;
        b.lj[k] = lj;
        if constexpr (Law::resists_turning) {
            b.mx[k] = out.mx;
            b.my[k] = out.my;
            b.mz[k] = out.mz;
        }
    }
}

void write_block(const PairBlock& b, int count, ContactForce* forces)
{
    const double* const from[] = {b.fx, b.fy, b.fz, b.li, b.tx, b.ty, b.tz, b.lj};
    for (int k = 0; k < count; k += width) {
        core::Eight f[width];
        for (int n = 0; n < width; ++n) f[n] = core::load_eight(from[n] + k);
        core::transpose(f);
        for (int lane = 0; lane < std::min(width, count - k); ++lane) core::store_eight(forces[k + lane].values, f[lane]);
    }
}

void write_couples(const PairBlock& b, int count, ContactCouple* couples)
{
    for (int k = 0; k < count; ++k) couples[k] = {{b.mx[k], b.my[k], b.mz[k], 0.0}};
}

bool any_coincident(const PairBlock& b, int count)
{
    int found = 0;
#pragma omp simd reduction(| : found)
    for (int k = 0; k < whole(count); ++k) {
        const double least = coincident_share * (b.ri[k] + b.rj[k]);
        found |= int(b.dx[k] * b.dx[k] + b.dy[k] * b.dy[k] + b.dz[k] * b.dz[k] < least * least);
    }
    return found != 0;
}

template <class Law, class Move>
void run_pairs(const PairScene& scene, const PairColumns& pair, int begin, int end, const Law& law, Move move)
{
    PairBlock block;
    for (; begin < end; begin += PairBlock::size) {
        const int count = std::min(PairBlock::size, end - begin);
        const auto bytes = std::size_t(count) * sizeof(double);
        const std::ptrdiff_t slot = begin + pair.offset;
        read_block(scene.records, pair, begin, count, move, block);
        for_each_spring(pair, begin, block, [&](const double* from, double* to) {
            std::memcpy(to, from, bytes);
            std::fill(to + count, to + whole(count), 0.0);
        });
        if (any_coincident(block, count)) separate(scene, pair, begin, count, block);
        if (pair.books) evaluate_block<Budget::kept>(law, count, block, pair.books + slot);
        else evaluate_block<Budget::none>(law, count, block, nullptr);
        for_each_spring(pair, begin, block, [&](double* to, const double* from) { std::memcpy(to, from, bytes); });
        write_block(block, count, pair.forces + slot);
        if constexpr (Law::resists_turning) write_couples(block, count, pair.couples + slot);
    }
}

/// A direction for two particles at the same place, from their ids.
core::Vec3 direction_of(std::uint64_t seed, std::int64_t low, std::int64_t high)
{
    const auto u = core::random_uniform(seed, low, std::uint64_t(high));
    const double z = 2.0 * u[0] - 1.0, around = 2.0 * std::numbers::pi * u[1], r = std::sqrt(1.0 - z * z);
    return {r * std::cos(around), r * std::sin(around), z};
}

void separate(const PairScene& scene, const PairColumns& pair, int begin, int count, PairBlock& b)
{
    const auto& id = scene.particles.id;
    for (int k = 0; k < whole(count); ++k) {
        const double least = coincident_share * (b.ri[k] + b.rj[k]);
        if (b.dx[k] * b.dx[k] + b.dy[k] * b.dy[k] + b.dz[k] * b.dz[k] >= least * least) continue;
        const int m = begin + std::min(k, count - 1);
        const auto d = direction_of(scene.seed, id[std::size_t(pair.first[m])], id[std::size_t(pair.second[m])]);
        b.dx[k] = least * d[0];
        b.dy[k] = least * d[1];
        b.dz[k] = least * d[2];
        for (double* lane : {b.sx, b.sy, b.sz, b.rx, b.ry, b.rz}) lane[k] = 0.0;
    }
}

} // namespace

void pair_forces(const PairScene& scene, core::NearPairs& near, int chunk, PairForces& forces)
{
    const std::ptrdiff_t offset = scene.slots.offset[std::size_t(chunk)];
    const PairColumns pair{scene.pairs.first.data(),
                           scene.pairs.second.data(),
                           near.spring[std::size_t(chunk)].data(),
                           scene.pairs.chunk_begin[std::size_t(chunk)],
                           near.count(chunk),
                           near.width(),
                           forces.forces.data(),
                           forces.couples.data(),
                           forces.books.empty() ? nullptr : forces.books.data(),
                           offset};
    const core::Vec3* shifts = scene.shifts.data();
    const std::uint8_t* image = scene.pairs.image.data();
    const auto shifted = [=](int m, const core::Eight& d) {
        const core::Vec3& shift = shifts[image[m]];
        return d + core::Eight{shift[0], shift[1], shift[2], 0.0, 0.0, 0.0, 0.0, 0.0};
    };
    const auto as_it_is = [](int, const core::Eight& d) { return d; };
    std::visit(
        [&]<class Law>(const std::vector<Law>& laws) {
            for (const core::NearRun& run : near.runs[std::size_t(chunk)]) {
                const Law& law = laws[std::size_t(run.kind)];
                if (run.shifted) run_pairs(scene, pair, run.begin, run.end, law, shifted);
                else run_pairs(scene, pair, run.begin, run.end, law, as_it_is);
            }
        },
        scene.laws);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact.hpp"
#include "core/base/error.hpp"
#include "core/base/four.hpp"
#include "core/base/random.hpp"

#include <numbers>

namespace physics {
namespace {

/// Centres closer than this share of the sum of their radii have no direction of their own.
constexpr double coincident_share = 1e-10;

/// The near pairs' columns that a force reads and moves.
struct PairColumns {
    const int *first, *second;
    const double* root_mass;
    std::vector<core::Column>& spring;
    ContactForce* forces;
    ContactCouple* couples;
    PairBook* books; ///< Null where no budget is kept.
};

/// The law of near pair m: the only one, or that of its two species.
template <class Law>
struct OneLaw {
    using law_type = Law;
    Law law;
    const Law& operator()(int) const { return law; }
};

template <class Law>
struct LawTable {
    using law_type = Law;
    const Law* laws;
    const std::uint16_t* kind;
    const Law& operator()(int m) const { return laws[kind[m]]; }
};

/// What the particles of some consecutive pairs bring together, and what comes out: small enough for the innermost cache.
struct alignas(64) PairBlock {
    static constexpr int size = 64;
    using Lane = double[size];
    Lane dx, dy, dz, vx, vy, vz;         ///< Second centre from the first; velocity of the first against the second.
    Lane ri, rj, ax, ay, az, bx, by, bz; ///< Radii and spins.
    Lane fx, fy, fz, tx, ty, tz, li, lj; ///< Force, normal x force, lever arms.
    Lane mx, my, mz;                     ///< Torque against turning.
};

/// Reads pairs [begin, begin + count); the places up to the next multiple of four repeat the last one.
/// @param shift_of  shift_of(m): the image shift, fourth value 0.
template <class ShiftOf>
void read_block(const MotionRecords::Record* records, const PairColumns& pair, int begin, int count, ShiftOf shift_of, PairBlock& b)
{
    using core::Four, core::load_four, core::store_four;
    for (int k = 0; k < count; k += 4) {
        Four d[4], v[4], wi[4], wj[4];
        for (int lane = 0; lane < 4; ++lane) {
            const int m = begin + std::min(k + lane, count - 1);
            const auto &first = records[pair.first[m]], &second = records[pair.second[m]];
            d[lane] = load_four(second.position) - load_four(first.position) + shift_of(m);
            v[lane] = load_four(first.velocity) - load_four(second.velocity);
            wi[lane] = load_four(first.spin);
            wj[lane] = load_four(second.spin);
        }
        for (auto* rows : {d, v, wi, wj}) core::transpose(rows[0], rows[1], rows[2], rows[3]);
        double* const to[] = {b.dx, b.dy, b.dz, b.vx, b.vy, b.vz, b.ax, b.ay, b.az, b.ri, b.bx, b.by, b.bz, b.rj};
        const Four from[] = {d[0], d[1], d[2], v[0], v[1], v[2], wi[0], wi[1], wi[2], wi[3], wj[0], wj[1], wj[2], wj[3]};
        for (int n = 0; n < 14; ++n) store_four(to[n] + k, from[n]);
    }
}

/// Gives pairs whose centres coincide a direction from their ids, and no spring.
void separate(const PairScene& scene, const PairColumns& pair, int begin, int count, PairBlock& b);

[[gnu::always_inline]] inline PairBook pair_book(const ContactBook& book, const ContactInput& in)
{
    return {book, {in.ny * book.fz - in.nz * book.fy, in.nz * book.fx - in.nx * book.fz, in.nx * book.fy - in.ny * book.fx}};
}

/// Forces of the pairs in the block; moves their springs. law_of(m) is the law of near pair m.
template <Budget budget, class LawOf>
void evaluate_block(const PairColumns& pair, int begin, int count, LawOf law_of, PairBlock& b)
{
    using Law = typename LawOf::law_type;
    const SpringColumns springs = spring_columns(pair.spring, std::size_t(begin));
    const double* root_mass = pair.root_mass + begin;
#pragma omp simd
    for (int k = 0; k < count; ++k) {
        const Law& law = law_of(begin + k);
        const double dx = b.dx[k], dy = b.dy[k], dz = b.dz[k];
        const double distance = std::sqrt(dx * dx + dy * dy + dz * dz), inverse = 1.0 / distance;
        ContactInput in;
        in.overlap = b.ri[k] + b.rj[k] - distance;
        in.nx = dx * inverse;
        in.ny = dy * inverse;
        in.nz = dz * inverse;
        in.vx = b.vx[k];
        in.vy = b.vy[k];
        in.vz = b.vz[k];
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
        in.root_mass = root_mass[k];
        in.radius = b.ri[k] * b.rj[k] / (b.ri[k] + b.rj[k]);
        in.ux = b.ax[k] - b.bx[k];
        in.uy = b.ay[k] - b.by[k];
        in.uz = b.az[k] - b.bz[k];
        const auto out = move_springs(law, in, springs, k);
        if constexpr (budget == Budget::kept) pair.books[begin + k] = pair_book(contact_book(law, in, out), in);
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
    for (int k = 0; k < count; k += 4) {
        core::Four f[] = {core::load_four(b.fx + k), core::load_four(b.fy + k), core::load_four(b.fz + k), core::load_four(b.li + k)};
        core::Four t[] = {core::load_four(b.tx + k), core::load_four(b.ty + k), core::load_four(b.tz + k), core::load_four(b.lj + k)};
        core::transpose(f[0], f[1], f[2], f[3]);
        core::transpose(t[0], t[1], t[2], t[3]);
        for (int lane = 0; lane < std::min(4, count - k); ++lane) {
            core::store_four(forces[k + lane].force, f[lane]);
            core::store_four(forces[k + lane].torque, t[lane]);
        }
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
    for (int k = 0; k < count; ++k) {
        const double least = coincident_share * (b.ri[k] + b.rj[k]);
        found |= int(b.dx[k] * b.dx[k] + b.dy[k] * b.dy[k] + b.dz[k] * b.dz[k] < least * least);
    }
    return found != 0;
}

template <class LawOf, class ShiftOf>
void run_pairs(const PairScene& scene, const PairColumns& pair, int begin, int end, LawOf law_of, ShiftOf shift_of)
{
    PairBlock block;
    for (; begin < end; begin += PairBlock::size) {
        const int count = std::min(PairBlock::size, end - begin);
        read_block(scene.records.data(), pair, begin, count, shift_of, block);
        if (any_coincident(block, count)) separate(scene, pair, begin, count, block);
        if (pair.books) evaluate_block<Budget::kept>(pair, begin, count, law_of, block);
        else evaluate_block<Budget::none>(pair, begin, count, law_of, block);
        write_block(block, count, pair.forces + begin);
        if constexpr (LawOf::law_type::resists_turning) write_couples(block, count, pair.couples + begin);
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
    for (int k = 0; k < count; ++k) {
        const double least = coincident_share * (b.ri[k] + b.rj[k]);
        if (b.dx[k] * b.dx[k] + b.dy[k] * b.dy[k] + b.dz[k] * b.dz[k] >= least * least) continue;
        const int m = begin + k;
        const auto d = direction_of(scene.seed, id[std::size_t(pair.first[m])], id[std::size_t(pair.second[m])]);
        b.dx[k] = least * d[0];
        b.dy[k] = least * d[1];
        b.dz[k] = least * d[2];
        for (auto& column : pair.spring) column[std::size_t(m)] = 0.0;
    }
}

template <class LawOf>
void run_chunk(const PairScene& scene, const core::NearPairs& near, int chunk, const PairColumns& pair, LawOf law_of)
{
    const int begin = scene.pairs.chunk_begin[std::size_t(chunk)], middle = near.plain_end[std::size_t(chunk)];
    run_pairs(scene, pair, begin, middle, law_of, [](int) { return core::Four{}; });
    const core::Vec3* shifts = scene.shifts.data();
    const std::uint8_t* image = near.image.data();
    run_pairs(scene, pair, middle, near.shifted_end[std::size_t(chunk)], law_of, [=](int m) {
        const core::Vec3& shift = shifts[image[m]];
        return core::Four{shift[0], shift[1], shift[2], 0.0};
    });
}

} // namespace

void pair_forces(const PairScene& scene, core::NearPairs& near, int chunk, PairForces& forces)
{
    const PairColumns pair{near.first.data(),
                           near.second.data(),
                           near.root_mass.data(),
                           near.spring,
                           forces.forces.data(),
                           forces.couples.data(),
                           forces.books.empty() ? nullptr : forces.books.data()};
    std::visit(
        [&]<class Law>(const std::vector<Law>& laws) {
            if (laws.size() == 1) run_chunk(scene, near, chunk, pair, OneLaw<Law>{laws.front()});
            else run_chunk(scene, near, chunk, pair, LawTable<Law>{laws.data(), near.kind.data()});
        },
        scene.laws);
}

} // namespace physics

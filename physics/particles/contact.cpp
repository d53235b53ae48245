// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/contact.hpp"
#include "core/base/error.hpp"
#include "core/base/random.hpp"

#include <numbers>

namespace physics {
namespace {

/// Columns of the particles as plain pointers, for vector code.
struct Columns {
    const double *x, *y, *z, *vx, *vy, *vz, *wx, *wy, *wz, *radius;
    explicit Columns(const core::ParticleSet& p)
        : x(p.position[0].data()), y(p.position[1].data()), z(p.position[2].data()), vx(p.velocity[0].data()),
          vy(p.velocity[1].data()), vz(p.velocity[2].data()), wx(p.spin[0].data()), wy(p.spin[1].data()), wz(p.spin[2].data()),
          radius(p.radius.data())
    {
    }
};

/// Centres closer than this share of the sum of their radii have no direction of their own.
constexpr double coincident_share = 1e-10;

/// The near pairs' columns that a force reads and moves.
struct PairColumns {
    const int *first, *second;
    const double* root_mass;
    double *sx, *sy, *sz;
    ContactForce* forces;
};

/// Evaluates near pair m, whose centres are (dx, dy, dz) apart.
inline void contact_of(const Columns& p, const PairColumns& pair, int m, double dx, double dy, double dz, const LinearContact& law)
{
    const int i = pair.first[m], j = pair.second[m];
    const double reach = p.radius[i] + p.radius[j], least = coincident_share * reach;
    const double distance = std::sqrt(std::max(dx * dx + dy * dy + dz * dz, least * least)), inverse = 1.0 / distance;
    ContactInput in;
    in.overlap = reach - distance;
    in.nx = dx * inverse;
    in.ny = dy * inverse;
    in.nz = dz * inverse;
    in.vx = p.vx[i] - p.vx[j];
    in.vy = p.vy[i] - p.vy[j];
    in.vz = p.vz[i] - p.vz[j];
    const double vn = in.vx * in.nx + in.vy * in.ny + in.vz * in.nz, back = 0.5 * law.step * inverse;
    in.mx = in.nx + back * (in.vx - vn * in.nx);
    in.my = in.ny + back * (in.vy - vn * in.ny);
    in.mz = in.nz + back * (in.vz - vn * in.nz);
    const double li = p.radius[i] - 0.5 * in.overlap, lj = p.radius[j] - 0.5 * in.overlap;
    in.wx = li * p.wx[i] + lj * p.wx[j];
    in.wy = li * p.wy[i] + lj * p.wy[j];
    in.wz = li * p.wz[i] + lj * p.wz[j];
    in.twist = 0.5 * ((p.wx[i] + p.wx[j]) * in.nx + (p.wy[i] + p.wy[j]) * in.ny + (p.wz[i] + p.wz[j]) * in.nz);
    in.sx = pair.sx[m];
    in.sy = pair.sy[m];
    in.sz = pair.sz[m];
    in.root_mass = pair.root_mass[m];
    const ContactOutput out = law(in);
    pair.sx[m] = out.sx;
    pair.sy[m] = out.sy;
    pair.sz[m] = out.sz;
    ContactForce& force = pair.forces[m];
    force.force[0] = out.fx;
    force.force[1] = out.fy;
    force.force[2] = out.fz;
    force.lever_first = li;
    force.torque[0] = in.ny * out.fz - in.nz * out.fy;
    force.torque[1] = in.nz * out.fx - in.nx * out.fz;
    force.torque[2] = in.nx * out.fy - in.ny * out.fx;
    force.lever_second = lj;
}

/// Near pairs [begin, end); law_of(m) gives the law, shift_of(m, axis) the image shift. Returns whether any centres coincide.
template <class LawOf, class ShiftOf>
bool run_pairs(const Columns p, const PairColumns pair, int begin, int end, LawOf law_of, ShiftOf shift_of)
{
    int coincident = 0;
#pragma omp simd reduction(| : coincident)
    for (int m = begin; m < end; ++m) {
        const int i = pair.first[m], j = pair.second[m];
        const double dx = p.x[j] - p.x[i] + shift_of(m, 0);
        const double dy = p.y[j] - p.y[i] + shift_of(m, 1);
        const double dz = p.z[j] - p.z[i] + shift_of(m, 2);
        const double least = coincident_share * (p.radius[i] + p.radius[j]);
        coincident |= int(dx * dx + dy * dy + dz * dz < least * least);
        contact_of(p, pair, m, dx, dy, dz, law_of(m));
    }
    return coincident != 0;
}

/// A direction for two particles at the same place, from their ids.
core::Vec3 direction_of(std::uint64_t seed, std::int64_t low, std::int64_t high)
{
    const auto u = core::random_uniform(seed, low, std::uint64_t(high));
    const double z = 2.0 * u[0] - 1.0, around = 2.0 * std::numbers::pi * u[1], r = std::sqrt(1.0 - z * z);
    return {r * std::cos(around), r * std::sin(around), z};
}

/// Pushes particles apart whose centres coincide, along directions from their ids, without friction.
template <class LawOf>
void separate(const PairScene& scene, const PairColumns& pair, int begin, int end, LawOf law_of)
{
    const auto& set = scene.particles;
    for (int m = begin; m < end; ++m) {
        const auto i = std::size_t(pair.first[m]), j = std::size_t(pair.second[m]);
        const double least = coincident_share * (set.radius[i] + set.radius[j]);
        if ((set.position_of(int(j)) - set.position_of(int(i))).squaredNorm() >= least * least) continue;
        const core::Vec3 d = least * direction_of(scene.seed, set.id[i], set.id[j]);
        pair.sx[m] = pair.sy[m] = pair.sz[m] = 0.0;
        contact_of(Columns(set), pair, m, d[0], d[1], d[2], law_of(m));
    }
}

template <class LawOf>
void run_chunk(const PairScene& scene, const core::NearPairs& near, int chunk, const PairColumns& pair, LawOf law_of)
{
    const int begin = scene.pairs.chunk_begin[std::size_t(chunk)], middle = near.plain_end[std::size_t(chunk)];
    const int end = near.shifted_end[std::size_t(chunk)];
    const Columns columns(scene.particles);
    if (run_pairs(columns, pair, begin, middle, law_of, [](int, int) { return 0.0; })) separate(scene, pair, begin, middle, law_of);
    const core::Vec3* shifts = scene.shifts.data();
    const std::uint8_t* image = near.image.data();
    run_pairs(columns, pair, middle, end, law_of, [=](int m, int axis) { return shifts[image[m]].data()[axis]; });
}

ContactLaws laws_of(const std::vector<ContactParameters>& entries, int wanted, double step)
{
    const int count = int(entries.size());
    core::require<core::ConfigError>(count == 1 || count == wanted,
                                     core::text(count, " sets of contact parameters are given where 1 or ", wanted, " are needed"));
    ContactLaws laws;
    for (const auto& entry : entries) laws.push_back(linear_contact(entry, step));
    return laws;
}

} // namespace

ContactLaws pair_laws(const ParticleParameters& parameters, double step)
{
    return laws_of(parameters.pairs, parameters.species * parameters.species, step);
}

ContactLaws wall_laws(const ParticleParameters& parameters, double step)
{
    return laws_of(parameters.walls, parameters.species, step);
}

void pair_forces(const PairScene& scene, core::NearPairs& near, int chunk, std::span<ContactForce> forces)
{
    const PairColumns pair{near.first.data(), near.second.data(), near.root_mass.data(), near.spring[0].data(),
                           near.spring[1].data(), near.spring[2].data(), forces.data()};
    if (scene.laws.size() == 1) {
        const LinearContact law = scene.laws.front();
        run_chunk(scene, near, chunk, pair, [law](int) { return law; });
    } else {
        const LinearContact* laws = scene.laws.data();
        const std::uint16_t* kind = near.kind.data();
        run_chunk(scene, near, chunk, pair, [=](int m) { return laws[kind[m]]; });
    }
}

} // namespace physics

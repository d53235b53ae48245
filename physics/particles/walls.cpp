// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/walls.hpp"
#include "core/base/error.hpp"
#include "physics/particles/wall_force.hpp"

#include <algorithm>

namespace physics {
namespace {

using core::Vec3;

constexpr auto index_of(int i) { return std::size_t(i); }

struct PlaneMeeting {
    double px, py, pz, nx, ny, nz;
    explicit PlaneMeeting(const PlaneWall& w)
        : px(w.point[0]), py(w.point[1]), pz(w.point[2]), nx(-w.normal[0]), ny(-w.normal[1]), nz(-w.normal[2])
    {
    }
    /// @param half  The way of the last half step [m].
    [[gnu::always_inline]] WallMeeting operator()(double x, double y, double z, double, double, double) const
    {
        return {nx, ny, nz, nx, ny, nz, (px - x) * nx + (py - y) * ny + (pz - z) * nz};
    }
};

struct CylinderMeeting {
    double px, py, pz, ax, ay, az, radius;
    explicit CylinderMeeting(const CylinderWall& w)
        : px(w.point[0]), py(w.point[1]), pz(w.point[2]), ax(w.axis[0]), ay(w.axis[1]), az(w.axis[2]), radius(w.radius)
    {
    }
    /// @param hx,hy,hz  The way of the last half step [m].
    [[gnu::always_inline]] WallMeeting operator()(double x, double y, double z, double hx, double hy, double hz) const
    {
        const double dx = x - px, dy = y - py, dz = z - pz;
        const double along = dx * ax + dy * ay + dz * az, h_along = hx * ax + hy * ay + hz * az;
        const double rx = dx - along * ax, ry = dy - along * ay, rz = dz - along * az;
        const double bx = rx - (hx - h_along * ax), by = ry - (hy - h_along * ay), bz = rz - (hz - h_along * az);
        const double distance = std::sqrt(rx * rx + ry * ry + rz * rz);
        const double tiny = 1e-12 * radius; // on the axis any direction is as good
        const double r = 1.0 / std::max(distance, tiny), b = 1.0 / std::max(std::sqrt(bx * bx + by * by + bz * bz), tiny);
        return {rx * r, ry * r, rz * r, bx * b, by * b, bz * b, radius - distance};
    }
};

PlaneMeeting meeting_of(const PlaneWall& w) { return PlaneMeeting(w); }
CylinderMeeting meeting_of(const CylinderWall& w) { return CylinderMeeting(w); }

/// The contacts [begin, end) of one wall: particles, no two alike, and springs.
struct WallColumns {
    const int* particle;
    SpringColumns springs;
    int begin, end;
};

/// law_of(i) is the law of particle i.
template <class Meet, class LawOf>
void run_contacts(const core::ParticleSet& p, const WallColumns& wall, const Meet meet, const LawOf law_of, ForceSums& sums)
{
    const ParticleColumns columns(p);
    const SumColumns add(sums);
    const auto first = index_of(sums.begin);
#pragma omp simd
    for (int k = wall.begin; k < wall.end; ++k) {
        const auto i = index_of(wall.particle[k]);
        const auto& law = law_of(i);
        const double half = 0.5 * law.step;
        const WallMeeting at =
            meet(columns.x[i], columns.y[i], columns.z[i], half * columns.vx[i], half * columns.vy[i], half * columns.vz[i]);
        ContactInput in = wall_input(columns, i, at);
        add_wall_force(move_springs(law, in, wall.springs, k), at, i - first, add);
    }
}

} // namespace

WallContacts::WallContacts(std::vector<Wall> walls) : walls_(std::move(walls)), lists_(walls_.size())
{
    for (auto& wall : walls_) {
        if (auto* plane = std::get_if<PlaneWall>(&wall)) {
            core::require<core::ConfigError>(plane->normal.norm() > 0, "a plane wall has a normal of length zero");
            plane->normal.normalize();
        }
        if (auto* cylinder = std::get_if<CylinderWall>(&wall)) {
            core::require<core::ConfigError>(cylinder->axis.norm() > 0 && cylinder->radius > 0,
                                             "a cylinder wall needs an axis and a positive radius");
            cylinder->axis.normalize();
        }
    }
}

void WallContacts::build(const core::ParticleSet& p, double skin, const core::ContactHistory& history)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        list.all.particle.clear();
        list.chunk_begin.clear();
        list.near_end.clear();
        list.all.spring.assign(index_of(history.width), {});
        std::visit(
            [&](const auto& wall) {
                const auto meet = meeting_of(wall);
                for (int i = 0; i < p.owned; ++i) {
                    if (i % core::particles_per_chunk == 0) list.chunk_begin.push_back(int(list.all.particle.size()));
                    const Vec3 x = p.position_of(i);
                    if (meet(x[0], x[1], x[2], 0, 0, 0).depth - p.radius[index_of(i)] >= skin) continue;
                    list.all.particle.push_back(i);
                    const auto kept = history.find(i, core::wall_key(std::int64_t(w)));
                    for (std::size_t a = 0; a < list.all.spring.size(); ++a) list.all.spring[a].push_back(kept[a]);
                }
            },
            walls_[w]);
        list.chunk_begin.push_back(int(list.all.particle.size()));
    }
}

void WallContacts::refresh(const core::ParticleSet& p, double skin, const core::Team& team)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        list.near.particle.resize(list.all.particle.size());
        list.place.resize(list.all.particle.size());
        list.near.spring.resize(list.all.spring.size());
        for (auto& column : list.near.spring) column.resize(list.all.particle.size());
        const int chunks = int(list.chunk_begin.size()) - 1;
        list.near_end.resize(index_of(chunks));
        std::visit(
            [&](const auto& wall) {
                const auto meet = meeting_of(wall);
                team.run(chunks, [&](int c) {
                    const auto begin = index_of(list.chunk_begin[index_of(c)]), end = index_of(list.chunk_begin[index_of(c) + 1]);
                    auto next = begin;
                    for (auto k = begin; k < end; ++k) {
                        const int i = list.all.particle[k];
                        const Vec3 x = p.position_of(i);
                        if (meet(x[0], x[1], x[2], 0, 0, 0).depth - p.radius[index_of(i)] >= skin) continue;
                        list.near.particle[next] = i;
                        list.place[next] = int(k);
                        for (std::size_t a = 0; a < list.all.spring.size(); ++a) list.near.spring[a][next] = list.all.spring[a][k];
                        ++next;
                    }
                    list.near_end[index_of(c)] = int(next);
                });
            },
            walls_[w]);
    }
}

void WallContacts::return_springs()
{
    for (auto& list : lists_)
        for (std::size_t c = 0; c < list.near_end.size(); ++c)
            for (auto k = index_of(list.chunk_begin[c]); k < index_of(list.near_end[c]); ++k)
                for (std::size_t a = 0; a < list.all.spring.size(); ++a)
                    list.all.spring[a][index_of(list.place[k])] = list.near.spring[a][k];
}

void WallContacts::append_row(int i, core::ContactHistory& history) const
{
    for (std::size_t w = 0; w < lists_.size(); ++w) {
        const Contacts& list = lists_[w].all;
        const auto found = std::lower_bound(list.particle.begin(), list.particle.end(), i);
        if (found == list.particle.end() || *found != i) continue;
        const auto k = std::size_t(found - list.particle.begin());
        core::Spring value{};
        for (std::size_t a = 0; a < list.spring.size(); ++a) value[a] = list.spring[a][k];
        if (value != core::Spring{}) history.add(core::wall_key(std::int64_t(w)), value);
    }
}

void WallContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk, ForceSums& sums)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        const WallColumns columns{list.near.particle.data(), spring_columns(list.near.spring), list.chunk_begin[index_of(chunk)],
                                  list.near_end[index_of(chunk)]};
        std::visit(
            [&](const auto& wall) {
                const auto meet = meeting_of(wall);
                with_wall_laws(laws, p, [&](const auto law_of) { run_contacts(p, columns, meet, law_of, sums); });
            },
            walls_[w]);
    }
}

} // namespace physics

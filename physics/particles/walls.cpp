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
    WallMeeting operator()(double x, double y, double z, double, double, double) const
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
    WallMeeting operator()(double x, double y, double z, double hx, double hy, double hz) const
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
        list.particle.clear();
        list.chunk_begin.clear();
        for (auto& column : list.spring) column.clear();
        std::visit(
            [&](const auto& wall) {
                const auto meet = meeting_of(wall);
                for (int i = 0; i < p.owned; ++i) {
                    if (i % core::particles_per_chunk == 0) list.chunk_begin.push_back(int(list.particle.size()));
                    const Vec3 x = p.position_of(i);
                    if (meet(x[0], x[1], x[2], 0, 0, 0).depth - p.radius[index_of(i)] >= skin) continue;
                    list.particle.push_back(i);
                    const auto kept = history.find(i, core::wall_key(std::int64_t(w)));
                    for (std::size_t a = 0; a < 3; ++a) list.spring[a].push_back(kept[a]);
                }
            },
            walls_[w]);
        list.chunk_begin.push_back(int(list.particle.size()));
    }
}

void WallContacts::append_row(int i, core::ContactHistory& history) const
{
    for (std::size_t w = 0; w < lists_.size(); ++w) {
        const auto& list = lists_[w];
        const auto found = std::lower_bound(list.particle.begin(), list.particle.end(), i);
        if (found == list.particle.end() || *found != i) continue;
        const auto k = std::size_t(found - list.particle.begin());
        const core::Spring value{list.spring[0][k], list.spring[1][k], list.spring[2][k]};
        if (value != core::Spring{0.0, 0.0, 0.0}) history.add(core::wall_key(std::int64_t(w)), value);
    }
}

void WallContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk, ForceSums& sums)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        std::visit(
            [&](const auto& wall) {
                const auto meet = meeting_of(wall);
                const int end = list.chunk_begin[index_of(chunk) + 1];
                for (auto k = index_of(list.chunk_begin[index_of(chunk)]); k < index_of(end); ++k) {
                    const auto i = index_of(list.particle[k]);
                    const LinearContact& law = laws.size() == 1 ? laws.front() : laws[index_of(p.species[i])];
                    const double half = 0.5 * law.step;
                    const WallMeeting at = meet(p.position[0][i], p.position[1][i], p.position[2][i], half * p.velocity[0][i],
                                            half * p.velocity[1][i], half * p.velocity[2][i]);
                    ContactInput in = wall_input(p, i, at);
                    in.sx = list.spring[0][k];
                    in.sy = list.spring[1][k];
                    in.sz = list.spring[2][k];
                    const ContactOutput out = law(in);
                    list.spring[0][k] = out.sx;
                    list.spring[1][k] = out.sy;
                    list.spring[2][k] = out.sz;
                    add_wall_force(out, at, i - index_of(sums.begin), sums);
                }
            },
            walls_[w]);
    }
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/walls.hpp"
#include "core/base/error.hpp"
#include "physics/particles/wall_block.hpp"

#include <algorithm>

namespace physics {
namespace {

using core::Vec3;

constexpr auto index_of(int i) { return std::size_t(i); }

PlaneWall placed(const PlaneWall& w, const WallPose& pose) { return {pose.place(w.point), pose.turn * w.normal}; }

CylinderWall placed(const CylinderWall& w, const WallPose& pose)
{
    return {pose.place(w.point), pose.turn * w.axis, w.radius, w.particles};
}

/// Of what a wall keeps to itself, a part in 10^12 is rounding.
bool vanishes(double part, double whole) { return std::abs(part) <= 1e-12 * whole; }

bool keeps_shape(const PlaneWall& w)
{
    const WallMotion& m = w.motion;
    return vanishes(m.velocity.dot(w.normal), m.velocity.norm()) && vanishes(m.amplitude.dot(w.normal), m.amplitude.norm()) &&
           vanishes(m.angular_velocity.cross(w.normal).norm(), m.angular_velocity.norm());
}

bool keeps_shape(const CylinderWall& w)
{
    const WallMotion& m = w.motion;
    const auto along = [&](const Vec3& v) { return vanishes(v.cross(w.axis).norm(), v.norm()); };
    return along(m.velocity) && along(m.amplitude) && along(m.angular_velocity) &&
           (m.angular_velocity.isZero(0.0) || vanishes((m.axis_point - w.point).cross(w.axis).norm(), w.radius));
}

} // namespace

WallContacts::WallContacts(std::vector<Wall> walls, std::vector<int> kinds, int species)
    : walls_(std::move(walls)),
      lists_(walls_.size()),
      kinds_(std::move(kinds)),
      kind_count_(1 + *std::max_element(kinds_.begin(), kinds_.end()))
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
    for (std::size_t w = 0; w < walls_.size(); ++w)
        std::visit(
            [&](const auto& wall) {
                lists_[w].frame = WallFrame(wall.motion);
                lists_[w].report = wall.report;
                lists_[w].first_kind = wall.material * species;
                lists_[w].same_shape = keeps_shape(wall);
            },
            walls_[w]);
}

/// Calls act(meet) for the wall where it is now.
template <class Act>
void WallContacts::with_meeting(std::size_t w, Act act) const
{
    const List& list = lists_[w];
    std::visit(
        [&](const auto& wall) {
            if (!list.frame.moves() && list.report < 0) return act(meeting_of(wall));
            const WallFrame& frame = list.frame;
            const auto own = meeting_of(wall);
            if (list.same_shape) act(MovedMeeting(own, own, frame));
            else act(MovedMeeting(meeting_of(placed(wall, frame.now())), meeting_of(placed(wall, frame.before())), frame));
        },
        walls_[w]);
}

void WallContacts::move_to(const WallTime& at)
{
    for (List& list : lists_) list.frame.move_to(at);
}

double WallContacts::way(const core::Bounds& box) const
{
    double greatest = 0.0;
    for (const List& list : lists_)
        if (!list.same_shape) greatest = std::max(greatest, list.frame.way(box));
    return greatest;
}

double WallContacts::near_way(const core::Bounds& box) const
{
    double greatest = 0.0;
    for (const List& list : lists_)
        if (!list.same_shape) greatest = std::max(greatest, list.frame.near_way(box));
    return greatest;
}

void WallContacts::build(const core::ParticleSet& p, double skin, const core::ContactHistory& history)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        list.all.particle.clear();
        list.chunk_begin.clear();
        list.runs.clear();
        list.all.spring.assign(index_of(history.width), {});
        list.frame.mark_listed();
        with_meeting(w, [&](const auto& meet) {
            for (int i = 0; i < p.owned; ++i) {
                if (i % core::particles_per_chunk == 0) list.chunk_begin.push_back(int(list.all.particle.size()));
                const Vec3 x = p.position_of(i);
                if (meet(x[0], x[1], x[2], 0, 0, 0).depth - p.radius[index_of(i)] >= skin) continue;
                list.all.particle.push_back(i);
                const auto kept = history.find(i, core::wall_key(std::int64_t(w)));
                for (std::size_t a = 0; a < list.all.spring.size(); ++a) list.all.spring[a].push_back(kept[a]);
            }
        });
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
        list.runs.resize(index_of(chunks));
        list.frame.mark_chosen();
        with_meeting(w, [&](const auto& meet) {
            team.run(chunks, [&](int c) {
                std::vector<int> near;
                for (int k = list.chunk_begin[index_of(c)]; k < list.chunk_begin[index_of(c) + 1]; ++k) {
                    const int i = list.all.particle[index_of(k)];
                    const Vec3 x = p.position_of(i);
                    if (meet(x[0], x[1], x[2], 0, 0, 0).depth - p.radius[index_of(i)] < skin) near.push_back(k);
                }
                choose(p, list, c, near);
            });
        });
    }
}

/// Those of one kind come one after the other.
void WallContacts::choose(const core::ParticleSet& p, List& list, int chunk, const std::vector<int>& near) const
{
    const int* kinds = kinds_.data() + list.first_kind;
    const auto kind_of = [&](int k) { return index_of(kinds[p.species[index_of(list.all.particle[index_of(k)])]]); };
    std::vector<int> next(index_of(kind_count_ + 1), 0);
    for (const int k : near) ++next[kind_of(k) + 1];
    next[0] = list.chunk_begin[index_of(chunk)];
    auto& runs = list.runs[index_of(chunk)];
    runs.clear();
    for (std::size_t kind = 0; kind + 1 < next.size(); ++kind) {
        next[kind + 1] += next[kind];
        if (next[kind + 1] > next[kind]) runs.push_back({next[kind], next[kind + 1], int(kind)});
    }
    for (const int k : near) {
        const auto place = index_of(next[kind_of(k)]++);
        list.near.particle[place] = list.all.particle[index_of(k)];
        list.place[place] = k;
        for (std::size_t a = 0; a < list.all.spring.size(); ++a) list.near.spring[a][place] = list.all.spring[a][index_of(k)];
    }
}

void WallContacts::return_springs()
{
    for (auto& list : lists_)
        for (const auto& runs : list.runs)
            for (const Run& run : runs)
                for (auto k = index_of(run.begin); k < index_of(run.end); ++k)
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

void WallContacts::add_forces(const MotionRecords::View& records, const ContactLaws& laws, int chunk, const WallSums& sums)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        const auto& runs = list.runs[index_of(chunk)];
        if (runs.empty()) continue;
        const int begin = runs.front().begin, end = runs.back().end;
        with_meeting(w, [&]<class Meet>(const Meet& meet) {
            std::conditional_t<Meet::moves, ContactNotes, NoNotes> notes;
            std::visit(
                [&](const auto& entries) {
                    for (const Run& run : runs) {
                        const WallColumns columns{list.near.particle.data(), list.near.spring, run.begin, run.end};
                        run_contacts(records, columns, meet, entries[index_of(run.kind)], sums, notes, run.begin - begin);
                    }
                },
                laws);
            if constexpr (Meet::moves)
                if (list.report >= 0) notes.add_to(sums.loads[index_of(list.report)], end - begin, list.frame.now().axis_point);
        });
    }
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/walls.hpp"
#include "core/base/error.hpp"
#include "physics/particles/wall_meeting.hpp"

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

/// The contacts [begin, end) of one wall: particles, no two alike, and springs.
struct WallColumns {
    const int* particle;
    SpringColumns springs;
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
    void add_to(WallLoad& load, int count, const Vec3& reference) const
    {
        const auto at = [](const std::array<Lane, 3>& lanes, std::size_t k) { return Vec3(lanes[0][k], lanes[1][k], lanes[2][k]); };
        for (std::size_t k = 0; k < index_of(count); ++k)
            if (const Vec3 push = at(force, k); !push.isZero(0.0)) load.add({push, at(couple, k), at(place, k) - reference, power[k]});
    }
};

/// Of a wall that is neither reported nor moves.
struct NoNotes {
    template <class Output>
    [[gnu::always_inline]] void take(std::size_t, double, double, double, const WallMeeting&, const Output&)
    {
    }
};

/// law_of(i) is the law of particle i.
template <Budget budget, class Meet, class LawOf, class Notes>
void run_contacts(const core::ParticleSet& p, const WallColumns& wall, const Meet meet, const LawOf law_of, const WallSums& sums,
                  Notes& notes)
{
    const ParticleColumns columns(p);
    const SumColumns add(sums.particles);
    const auto first = index_of(sums.particles.begin);
#pragma omp simd
    for (int k = wall.begin; k < wall.end; ++k) {
        const auto i = index_of(wall.particle[k]);
        const auto& law = law_of(i);
        const double half = 0.5 * law.step, x = columns.x[i], y = columns.y[i], z = columns.z[i];
        const auto at = meet(x, y, z, half * columns.vx[i], half * columns.vy[i], half * columns.vz[i]);
        ContactInput in = wall_input(columns, i, at);
        const auto out = move_springs(law, in, wall.springs, k);
        add_wall_force(out, at, i - first, add);
        notes.take(index_of(k - wall.begin), x, y, z, at, out);
        if constexpr (budget == Budget::kept) {
            const ContactBook book = contact_book(law, in, out);
            add_wall_book(book, at, i - first, *sums.energy);
            if constexpr (Meet::moves) add_wall_work(out, book, meet.present(x, y, z, at), i - first, *sums.energy);
        }
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
    for (std::size_t w = 0; w < walls_.size(); ++w)
        std::visit(
            [&](const auto& wall) {
                lists_[w].frame = WallFrame(wall.motion);
                lists_[w].report = wall.report;
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
        list.near_end.clear();
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
        list.near_end.resize(index_of(chunks));
        list.frame.mark_chosen();
        with_meeting(w, [&](const auto& meet) {
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
        });
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

void WallContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk, const WallSums& sums)
{
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        auto& list = lists_[w];
        const WallColumns columns{list.near.particle.data(), spring_columns(list.near.spring), list.chunk_begin[index_of(chunk)],
                                  list.near_end[index_of(chunk)]};
        with_meeting(w, [&]<class Meet>(const Meet& meet) {
            std::conditional_t<Meet::moves, ContactNotes, NoNotes> notes;
            with_wall_laws(laws, p, [&](const auto law_of) {
                if (sums.energy) run_contacts<Budget::kept>(p, columns, meet, law_of, sums, notes);
                else run_contacts<Budget::none>(p, columns, meet, law_of, sums, notes);
            });
            if constexpr (Meet::moves)
                if (list.report >= 0)
                    notes.add_to(sums.loads[index_of(list.report)], columns.end - columns.begin, list.frame.now().axis_point);
        });
    }
}

} // namespace physics

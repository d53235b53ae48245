// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/surface_contacts.hpp"

#include <algorithm>

namespace physics {
namespace {

using core::Vec3;

constexpr double same_contact = 0.9848; // cosine of 10 degrees: two hits are one contact
constexpr auto index_of(int i) { return std::size_t(i); }

core::Four gather(const core::Column& column, const std::array<int, 4>& i)
{
    return core::Four{column[index_of(i[0])], column[index_of(i[1])], column[index_of(i[2])], column[index_of(i[3])]};
}

/// Four points in the frame of a wall.
std::array<core::Four, 3> own_four(const WallPose& pose, const core::Four& x, const core::Four& y, const core::Four& z)
{
    const core::Four dx = x - pose.shift[0], dy = y - pose.shift[1], dz = z - pose.shift[2];
    const auto along = [&](int a) { return core::Four(pose.turn(0, a) * dx + pose.turn(1, a) * dy + pose.turn(2, a) * dz); };
    return {along(0), along(1), along(2)};
}

} // namespace

bool SurfaceContacts::touches(const Vec3& centre, double radius) const
{
    std::vector<int> found;
    surface_.candidates(own(centre), radius, 0.0, found);
    return !found.empty();
}

void SurfaceContacts::build(const core::ParticleSet& particles, double skin, double near_skin, const core::ContactHistory& history)
{
    near_skin_ = near_skin;
    frame_.mark_listed();
    chunks_.resize(index_of((particles.owned + core::particles_per_chunk - 1) / core::particles_per_chunk));
    std::vector<int> found;
    for (int i = 0; i < particles.owned; ++i) {
        auto& chunk = chunks_[index_of(i / core::particles_per_chunk)];
        if (i % core::particles_per_chunk == 0) {
            chunk.listed = Pairs{};
            chunk.contacts.clear();
            chunk.turns.clear();
        }
        surface_.candidates(own(particles.position_of(i)), particles.radius[index_of(i)], skin, found);
        for (const int t : found) chunk.listed.add(i, t);
        recall(i, history, chunk);
    }
    for (auto& chunk : chunks_) make_filters(particles, chunk);
}

void SurfaceContacts::make_filters(const core::ParticleSet& particles, Chunk& chunk) const
{
    const Pairs& listed = chunk.listed;
    chunk.filters.resize(index_of((listed.size() + 3) / 4));
    for (int begin = 0; begin < listed.size(); begin += 4) {
        const auto i = listed.particles_from(begin), triangle = listed.triangles_from(begin);
        for (std::size_t lane = 0; lane < 4; ++lane)
            chunk.filters[index_of(begin / 4)].set(int(lane),
                                                   surface_.bounds(triangle[lane], particles.radius[index_of(i[lane])], near_skin_));
    }
}

void SurfaceContacts::choose_near(const core::ParticleSet& p, Chunk& chunk) const
{
    const Pairs& listed = chunk.listed;
    chunk.near.particle.clear();
    chunk.near.triangle.clear();
    for (int begin = 0; begin < listed.size(); begin += 4) {
        const auto i = listed.particles_from(begin);
        std::array<core::Four, 3> x{gather(p.position[0], i), gather(p.position[1], i), gather(p.position[2], i)};
        if (frame_.moves()) x = own_four(frame_.now(), x[0], x[1], x[2]);
        const auto inside = chunk.filters[index_of(begin / 4)](x[0], x[1], x[2]);
        for (int m = begin; m < std::min(begin + 4, listed.size()); ++m) {
            if (!inside[m - begin]) continue;
            const int particle = listed.particle[index_of(m)], t = listed.triangle[index_of(m)];
            if (surface_.plain(t) || surface_.near(t, own(p.position_of(particle)), p.radius[index_of(particle)], near_skin_))
                chunk.near.add(particle, t);
        }
    }
}

void SurfaceContacts::refresh(const core::ParticleSet& particles, const core::Team& team)
{
    frame_.mark_chosen();
    team.run(int(chunks_.size()), [&](int c) {
        choose_near(particles, chunks_[index_of(c)]);
        gather_patches(chunks_[index_of(c)]);
    });
}

FourPatches SurfaceContacts::patches_of(const Pairs& pairs, int begin) const
{
    FourPatches patches;
    patches.read(surface_.patches().data(), pairs.triangles_from(begin));
    return patches;
}

/// So that the steps until the next refresh read them one after the other.
void SurfaceContacts::gather_patches(Chunk& chunk) const
{
    const int pairs = chunk.near.size();
    chunk.patches.resize(index_of((pairs + 3) / 4));
    chunk.feet.resize(chunk.patches.size());
    chunk.plain.resize(index_of(pairs));
    for (int begin = 0; begin < pairs; begin += 4) chunk.patches[index_of(begin / 4)] = patches_of(chunk.near, begin);
    for (int m = 0; m < pairs; ++m) chunk.plain[index_of(m)] = surface_.plain(chunk.near.triangle[index_of(m)]);
}

void SurfaceContacts::find_feet(const core::ParticleSet& p, double half_step, Chunk& chunk) const
{
    using core::Four;
    for (int begin = 0; begin < chunk.near.size(); begin += 4) {
        const FourPatches& patch = chunk.patches[index_of(begin / 4)];
        const auto i = chunk.near.particles_from(begin);
        const auto &x = p.position, &v = p.velocity;
        const Four px = gather(x[0], i), py = gather(x[1], i), pz = gather(x[2], i);
        const Four wx = half_step * gather(v[0], i), wy = half_step * gather(v[1], i), wz = half_step * gather(v[2], i);
        PatchPoint<Four> centre, earlier;
        if (frame_.moves()) {
            const auto now = own_four(frame_.now(), px, py, pz), before = own_four(frame_.before(), px - wx, py - wy, pz - wz);
            centre = patch_point(patch, now[0], now[1], now[2]);
            earlier = patch_point(patch, before[0], before[1], before[2]);
        } else {
            centre = patch_point(patch, px, py, pz);
            const auto way = patch_way(patch, wx, wy, wz);
            earlier = {centre.one - way.one, centre.two - way.two, centre.height - way.height};
        }
        const auto now = find_foot(patch, centre);
        const auto before = patch_foot(patch, earlier, improve_foot(patch, earlier, {now.one, now.two}));
        const Four zero = 1.0 - now.one - now.two, inside = core::lesser(core::lesser(now.one, now.two), zero);
        chunk.feet[index_of(begin / 4)] = {now, before.nx, before.ny, before.nz, inside};
    }
}

SurfaceContacts::Touch SurfaceContacts::touch_of(const Chunk& chunk, int pair) const
{
    const Feet& feet = chunk.feet[index_of(pair / 4)];
    const int lane = pair % 4;
    const double side = surface_.two_sided() && feet.now.depth[lane] < 0.0 ? -1.0 : 1.0;
    return {{side * Vec3(feet.now.nx[lane], feet.now.ny[lane], feet.now.nz[lane]), side * feet.now.depth[lane]},
            side * Vec3(feet.before_x[lane], feet.before_y[lane], feet.before_z[lane]),
            surface_.material(chunk.near.triangle[index_of(pair)])};
}

/// Touches of the particle of near pairs [begin, end), the deepest first.
/// @param centre  In the surface's own frame, like all touches [m].
void SurfaceContacts::add_near_touches(const Vec3& centre, double radius, int begin, int end, Chunk& chunk) const
{
    auto& touches = chunk.touches;
    touches.clear();
    for (int m = begin; m < end; ++m) {
        const Feet& feet = chunk.feet[index_of(m / 4)];
        const int lane = m % 4, triangle = chunk.near.triangle[index_of(m)];
        const bool plain = chunk.plain[index_of(m)];
        if (feet.inside[lane] < -patch_overlap && plain) continue;
        Touch touch = touch_of(chunk, m);
        const PatchPlace<double> foot{feet.now.one[lane], feet.now.two[lane]};
        if (feet.inside[lane] < -patch_overlap || (!plain && surface_.beyond_sharp_edge(triangle, foot))) {
            const Vec3 face = touch.hit.normal;
            if (!surface_.meet_rim(triangle, foot, centre, touch.hit)) continue;
            touch.before = (touch.before + touch.hit.normal - face).normalized();
        }
        if (std::abs(touch.hit.depth) >= radius + place_.reach) continue;
        // a place of its own behind all that are not less deep
        auto place = touches.end();
        while (place != touches.begin() && touch.hit.depth < (place - 1)->hit.depth) --place;
        touches.insert(place, touch);
    }
}

/// What lies behind the nearest place of a surface with two sides is hidden from the particle.
void SurfaceContacts::drop_touches_behind(std::vector<Touch>& touches)
{
    const SurfaceHit first = touches.front().hit;
    const auto hidden = [&](const Touch& t) { return first.depth < t.hit.depth * t.hit.normal.dot(first.normal); };
    touches.erase(std::remove_if(touches.begin() + 1, touches.end(), hidden), touches.end());
}

/// The same, each place once.
void SurfaceContacts::find_touches(const Vec3& centre, double radius, int begin, int end, Chunk& chunk) const
{
    add_near_touches(centre, radius, begin, end, chunk);
    auto& touches = chunk.touches;
    if (touches.size() < 2) return;
    if (surface_.two_sided()) drop_touches_behind(touches);
    // a centre behind one face but before another is outside an edge, not inside the wall
    else if (touches.back().hit.depth > 0.0)
        touches.erase(touches.begin(), std::find_if(touches.begin(), touches.end(), [](const Touch& t) { return t.hit.depth > 0.0; }));
    auto kept = touches.begin();
    for (const Touch& t : touches) {
        const auto same = [&](const Touch& other) { return other.hit.normal.dot(t.hit.normal) > same_contact; };
        if (std::none_of(touches.begin(), kept, same)) *kept++ = t;
    }
    touches.erase(kept, touches.end());
}

void SurfaceContacts::finish(const core::ParticleSet& p, const ContactLaws& laws, SurfaceTouches& block, Chunk& chunk,
                             const WallSums& sums) const
{
    const ParticleColumns columns = columns_of(p);
    const WallVelocity velocity(frame_.before());
    const auto evaluate = [&]<Budget budget>(const auto law_of) {
        if (frame_.moves()) block.evaluate_moving<budget>(columns, law_of, velocity);
        else block.evaluate<budget>(columns, law_of);
    };
    with_laws(laws, block.law, [&](const auto law_of) {
        if (sums.energy) evaluate.template operator()<Budget::kept>(law_of);
        else evaluate.template operator()<Budget::none>(law_of);
    });
    block.add_to(columns_of(sums.particles), index_of(sums.particles.begin));
    if (sums.shares) block.measure(p.radius, index_of(sums.particles.begin), *sums.shares);
    if (sums.energy) block.add_books(columns, index_of(sums.particles.begin), WallVelocity(frame_.now()), *sums.energy);
    for (int k = 0; k < block.count; ++k) chunk.contacts.push_back({block.particle[k], block.normal(k), block.tangential(k)});
    for (int k = 0; k < block.count && block.turning; ++k) chunk.turns.push_back(block.turn(k));
    for (int k = 0; k < block.count && place_.report >= 0; ++k) {
        const Vec3 place = p.position_of(block.particle[k]) + block.depth[k] * block.normal(k);
        const MovingMeeting at = block.meeting(columns, k, 0.5 * step_of(laws), velocity);
        const Vec3 force = block.force(k), couple = block.couple(k);
        const double power = force.dot(Vec3(at.ux, at.uy, at.uz)) + couple.dot(Vec3(at.ox, at.oy, at.oz));
        if (!force.isZero(0.0)) sums.loads[index_of(place_.report)].add({force, couple, place - frame_.now().axis_point, power});
    }
    block.count = 0;
}

void SurfaceContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk_number, const WallSums& sums)
{
    Chunk& chunk = chunks_[index_of(chunk_number)];
    find_feet(p, 0.5 * step_of(laws), chunk);
    std::swap(chunk.contacts, chunk.contacts_before);
    chunk.contacts.clear();
    std::swap(chunk.turns, chunk.turns_before);
    chunk.turns.clear();
    SurfaceTouches block;
    const auto old_end = chunk.contacts_before.end();
    auto old = chunk.contacts_before.begin();
    const int pairs = chunk.near.size(), *particle = chunk.near.particle.data();
    for (int begin = 0, end = 0; begin < pairs; begin = end) {
        const int i = particle[begin];
        while (end < pairs && particle[end] == i) ++end;
        const double radius = p.radius[index_of(i)];
        while (old != old_end && old->particle < i) ++old;
        auto next = old;
        while (next != old_end && next->particle == i) ++next;
        const auto add = [&](const Touch& t) {
            if (block.count == SurfaceTouches::size) finish(p, laws, block, chunk, sums);
            const bool moves = frame_.moves();
            const Vec3 normal = moves ? Vec3(frame_.now().turn * t.hit.normal) : t.hit.normal;
            const Vec3 before = moves ? Vec3(frame_.before().turn * t.before) : t.before;
            const auto start = chunk.contacts_before.begin();
            const int law = t.material * place_.species + p.species[index_of(i)];
            block.add(i, law, {normal, before, t.hit.depth}, take_spring(chunk, old - start, next - start, -normal));
        };
        if (end == begin + 1 && chunk.plain[index_of(begin)]) { // most of them
            const Feet& feet = chunk.feet[index_of(begin / 4)];
            const int lane = begin % 4;
            if (feet.inside[lane] >= -patch_overlap && std::abs(feet.now.depth[lane]) < radius + place_.reach) add(touch_of(chunk, begin));
        } else {
            find_touches(own(p.position_of(i)), radius, begin, end, chunk);
            for (const Touch& t : chunk.touches) add(t);
        }
        old = next;
    }
    finish(p, laws, block, chunk, sums);
}

} // namespace physics

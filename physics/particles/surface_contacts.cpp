// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/surface_contacts.hpp"

#include <algorithm>

namespace physics {
namespace {

using core::Vec3;

constexpr double same_contact = 0.9848;         // cosine of 10 degrees: two hits are one contact
constexpr double same_friction = 0.7071;        // cosine of 45 degrees: a contact goes on
constexpr std::int64_t first_feature = 1 << 20; // analytic walls have lower numbers
constexpr auto index_of(int i) { return std::size_t(i); }

core::Four gather(const core::Column& column, const std::array<int, 4>& i)
{
    return core::Four{column[index_of(i[0])], column[index_of(i[1])], column[index_of(i[2])], column[index_of(i[3])]};
}

core::Spring spring_of(const Vec3& v) { return {v[0], v[1], v[2]}; }
Vec3 vector_of(const core::Spring& s) { return {s[0], s[1], s[2]}; }
Vec3 turn_of(const core::Spring& s) { return {s[3], s[4], s[5]}; }

} // namespace

core::Spring SurfaceContacts::take_spring(Chunk& chunk, std::ptrdiff_t first, std::ptrdiff_t last, const Vec3& normal)
{
    const auto begin = chunk.contacts_before.begin();
    auto best = begin + last;
    double likeness = same_friction;
    for (auto c = begin + first; c != begin + last; ++c) {
        const double like = c->normal.dot(normal);
        if (like <= likeness) continue;
        likeness = like;
        best = c;
    }
    if (best == begin + last) return {};
    best->normal.setZero();
    core::Spring spring = spring_of(best->spring);
    if (!chunk.turns_before.empty())
        for (int a = 0; a < 3; ++a) spring[index_of(3 + a)] = chunk.turns_before[std::size_t(best - begin)][a];
    return spring;
}

void SurfaceContacts::build(const core::ParticleSet& particles, double skin, double near_skin, const core::ContactHistory& history)
{
    near_skin_ = near_skin;
    chunks_.resize(index_of((particles.owned + core::particles_per_chunk - 1) / core::particles_per_chunk));
    std::vector<int> found;
    for (int i = 0; i < particles.owned; ++i) {
        auto& chunk = chunks_[index_of(i / core::particles_per_chunk)];
        if (i % core::particles_per_chunk == 0) {
            chunk.listed = Pairs{};
            chunk.contacts.clear();
            chunk.turns.clear();
        }
        surface_.candidates(particles.position_of(i), particles.radius[index_of(i)], skin, found);
        for (const int t : found) chunk.listed.add(i, t);
        for (std::int64_t k = first_feature;; k += 2) {
            const core::Spring spring = history.find(i, core::wall_key(k));
            if (spring == core::Spring{}) break;
            chunk.contacts.push_back({i, vector_of(history.find(i, core::wall_key(k + 1))), vector_of(spring)});
            if (history.width == core::rolling_memory) chunk.turns.push_back(turn_of(spring));
        }
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
        const auto& x = p.position;
        const auto inside = chunk.filters[index_of(begin / 4)](gather(x[0], i), gather(x[1], i), gather(x[2], i));
        for (int m = begin; m < std::min(begin + 4, listed.size()); ++m) {
            if (!inside[m - begin]) continue;
            const int particle = listed.particle[index_of(m)], t = listed.triangle[index_of(m)];
            if (surface_.plain(t) || surface_.near(t, p.position_of(particle), p.radius[index_of(particle)], near_skin_))
                chunk.near.add(particle, t);
        }
    }
}

void SurfaceContacts::refresh(const core::ParticleSet& particles, const core::Team& team)
{
    team.run(int(chunks_.size()), [&](int c) {
        choose_near(particles, chunks_[index_of(c)]);
        gather_patches(chunks_[index_of(c)]);
    });
}

void SurfaceContacts::append_row(int i, core::ContactHistory& history) const
{
    const std::size_t c = index_of(i / core::particles_per_chunk);
    if (c >= chunks_.size()) return;
    const Chunk& chunk = chunks_[c];
    const auto& contacts = chunk.contacts;
    auto contact =
        std::lower_bound(contacts.begin(), contacts.end(), i, [](const Contact& a, int particle) { return a.particle < particle; });
    std::int64_t k = first_feature;
    for (; contact != contacts.end() && contact->particle == i; ++contact) {
        core::Spring spring = spring_of(contact->spring);
        if (!chunk.turns.empty())
            for (int a = 0; a < 3; ++a) spring[index_of(3 + a)] = chunk.turns[std::size_t(contact - contacts.begin())][a];
        if (spring == core::Spring{}) continue;
        history.add(core::wall_key(k++), spring);
        history.add(core::wall_key(k++), spring_of(contact->normal));
    }
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
        const auto centre = patch_point(patch, gather(x[0], i), gather(x[1], i), gather(x[2], i));
        const Four wx = half_step * gather(v[0], i), wy = half_step * gather(v[1], i), wz = half_step * gather(v[2], i);
        const auto way = patch_way(patch, wx, wy, wz);
        const PatchPoint<Four> earlier{centre.one - way.one, centre.two - way.two, centre.height - way.height};
        const auto now = find_foot(patch, centre);
        const auto before = patch_foot(patch, earlier, improve_foot(patch, earlier, {now.one, now.two}));
        const Four zero = 1.0 - now.one - now.two, inside = core::lesser(core::lesser(now.one, now.two), zero);
        chunk.feet[index_of(begin / 4)] = {now, before.nx, before.ny, before.nz, inside};
    }
}

SurfaceContacts::Touch SurfaceContacts::touch_of(const Feet& feet, int lane)
{
    return {{Vec3(feet.now.nx[lane], feet.now.ny[lane], feet.now.nz[lane]), feet.now.depth[lane]},
            Vec3(feet.before_x[lane], feet.before_y[lane], feet.before_z[lane])};
}

/// Touches of the particle of near pairs [begin, end), the deepest first.
void SurfaceContacts::find_touches(const Vec3& centre, double radius, int begin, int end, Chunk& chunk) const
{
    auto& touches = chunk.touches;
    touches.clear();
    for (int m = begin; m < end; ++m) {
        const Feet& feet = chunk.feet[index_of(m / 4)];
        const int lane = m % 4;
        if (feet.inside[lane] < -patch_overlap && chunk.plain[index_of(m)]) continue;
        Touch touch = touch_of(feet, lane);
        if (feet.inside[lane] < -patch_overlap) {
            const Vec3 face = touch.hit.normal;
            const PatchPlace<double> foot{feet.now.one[lane], feet.now.two[lane]};
            if (!surface_.meet_rim(chunk.near.triangle[index_of(m)], foot, centre, touch.hit)) continue;
            touch.before = (touch.before + touch.hit.normal - face).normalized();
        }
        if (std::abs(touch.hit.depth) >= radius) continue;
        // a place of its own behind all that are not less deep
        auto place = touches.end();
        while (place != touches.begin() && touch.hit.depth < (place - 1)->hit.depth) --place;
        touches.insert(place, touch);
    }
    if (touches.size() < 2) return;
    // a centre behind one face but before another is outside an edge, not inside the wall
    if (touches.back().hit.depth > 0.0)
        touches.erase(touches.begin(), std::find_if(touches.begin(), touches.end(), [](const Touch& t) { return t.hit.depth > 0.0; }));
    auto kept = touches.begin();
    for (const Touch& t : touches) {
        const auto same = [&](const Touch& other) { return other.hit.normal.dot(t.hit.normal) > same_contact; };
        if (std::none_of(touches.begin(), kept, same)) *kept++ = t;
    }
    touches.erase(kept, touches.end());
}

void SurfaceContacts::finish(const core::ParticleSet& p, const ContactLaws& laws, SurfaceTouches& block, Chunk& chunk, ForceSums& sums)
{
    const ParticleColumns columns(p);
    with_wall_laws(laws, p, [&](const auto law_of) { block.evaluate(columns, law_of); });
    block.add_to(SumColumns(sums), index_of(sums.begin));
    for (int k = 0; k < block.count; ++k) chunk.contacts.push_back({block.particle[k], block.normal(k), block.tangential(k)});
    for (int k = 0; k < block.count && block.turning; ++k) chunk.turns.push_back(block.turn(k));
    block.count = 0;
}

void SurfaceContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk_number, ForceSums& sums)
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
            const auto start = chunk.contacts_before.begin();
            block.add(i, t.hit.normal, t.before, t.hit.depth, take_spring(chunk, old - start, next - start, -t.hit.normal));
        };
        if (end == begin + 1 && chunk.plain[index_of(begin)]) { // most of them
            const Feet& feet = chunk.feet[index_of(begin / 4)];
            const int lane = begin % 4;
            if (feet.inside[lane] >= -patch_overlap && std::abs(feet.now.depth[lane]) < radius) add(touch_of(feet, lane));
        } else {
            find_touches(p.position_of(i), radius, begin, end, chunk);
            for (const Touch& t : chunk.touches) add(t);
        }
        old = next;
    }
    finish(p, laws, block, chunk, sums);
}

} // namespace physics

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/surface_contacts.hpp"
#include "physics/particles/wall_force.hpp"

#include <algorithm>

namespace physics {
namespace {

using core::Vec3;

constexpr double same_contact = 0.9848;     // cosine of 10 degrees: two hits are one contact
constexpr double same_friction = 0.7071;    // cosine of 45 degrees: a contact goes on
constexpr std::int64_t first_feature = 1 << 20; // analytic walls have lower numbers
constexpr int block_size = 32;

constexpr auto index_of(int i) { return std::size_t(i); }

/// The patches of some pairs side by side.
struct alignas(64) PatchBlock {
    double value[WallPatch::size][block_size];

    [[nodiscard]] double operator()(int n, int k) const { return value[n][k]; }

    /// Reads `count` patches; the places up to the next multiple of four repeat the last one.
    void read(const WallPatch* patches, const int* triangle, int count)
    {
        for (int k = 0; k < count; k += 4) {
            const double* from[4];
            for (int lane = 0; lane < 4; ++lane) from[lane] = patches[triangle[std::min(k + lane, count - 1)]].value.data();
            for (int n = 0; n < WallPatch::size; n += 4) {
                core::Four rows[4];
                for (int lane = 0; lane < 4; ++lane) rows[lane] = core::load_four(from[lane] + n);
                core::transpose(rows[0], rows[1], rows[2], rows[3]);
                for (int lane = 0; lane < 4; ++lane) core::store_four(value[n + lane] + k, rows[lane]);
            }
        }
    }
};

/// Feet of some pairs side by side.
struct alignas(64) FootLanes {
    using Lane = double[block_size];
    Lane x, y, z, wx, wy, wz; ///< Centre; its way in the last half step [m].
    Lane one, two, nx, ny, nz, depth, bx, by, bz;
};

void evaluate_feet(const PatchBlock& block, int count, FootLanes& lanes)
{
#pragma omp simd
    for (int k = 0; k < count; ++k) {
        const PatchPoint centre = patch_point(block, k, lanes.x[k], lanes.y[k], lanes.z[k]);
        const PatchPoint way = patch_way(block, k, lanes.wx[k], lanes.wy[k], lanes.wz[k]);
        const PatchPoint earlier{centre.one - way.one, centre.two - way.two, centre.height - way.height};
        const PatchFoot now = find_foot(block, k, centre);
        const PatchFoot before = patch_foot(block, k, earlier, improve_foot(block, k, earlier, {now.one, now.two}));
        lanes.one[k] = now.one;
        lanes.two[k] = now.two;
        lanes.nx[k] = now.nx;
        lanes.ny[k] = now.ny;
        lanes.nz[k] = now.nz;
        lanes.depth[k] = now.depth;
        lanes.bx[k] = before.nx;
        lanes.by[k] = before.ny;
        lanes.bz[k] = before.nz;
    }
}

core::Spring spring_of(const Vec3& v) { return {v[0], v[1], v[2]}; }
Vec3 vector_of(const core::Spring& s) { return {s[0], s[1], s[2]}; }

/// The spring of the contact among [first, last) of the most similar normal, which is spent; zero if there is none.
template <class Iterator>
Vec3 take_spring(Iterator first, Iterator last, const Vec3& normal)
{
    Iterator best = last;
    double likeness = same_friction;
    for (Iterator c = first; c != last; ++c) {
        const double like = c->normal.dot(normal);
        if (like <= likeness) continue;
        likeness = like;
        best = c;
    }
    if (best == last) return Vec3::Zero();
    best->normal.setZero();
    return best->spring;
}

} // namespace

void SurfaceContacts::build(const core::ParticleSet& particles, double skin, const core::ContactHistory& history)
{
    chunks_.resize(index_of((particles.owned + core::particles_per_chunk - 1) / core::particles_per_chunk));
    std::vector<int> found;
    for (int i = 0; i < particles.owned; ++i) {
        auto& chunk = chunks_[index_of(i / core::particles_per_chunk)];
        if (i % core::particles_per_chunk == 0) {
            chunk.listed = Pairs{};
            chunk.contacts.clear();
        }
        surface_.candidates(particles.position_of(i), particles.radius[index_of(i)], skin, found);
        for (const int t : found) chunk.listed.add(i, t);
        for (std::int64_t k = first_feature;; k += 2) {
            const Vec3 spring = vector_of(history.find(i, core::wall_key(k)));
            if (spring.isZero(0.0)) break;
            chunk.contacts.push_back({i, vector_of(history.find(i, core::wall_key(k + 1))), spring});
        }
    }
}

void SurfaceContacts::refresh(const core::ParticleSet& particles, double skin, const core::Team& team)
{
    team.run(int(chunks_.size()), [&](int c) {
        auto& chunk = chunks_[index_of(c)];
        const Pairs& listed = chunk.listed;
        chunk.near.particle.clear();
        chunk.near.triangle.clear();
        for (std::size_t m = 0; m < listed.particle.size(); ++m) {
            const int i = listed.particle[m], t = listed.triangle[m];
            if (surface_.near(t, particles.position_of(i), particles.radius[index_of(i)], skin)) chunk.near.add(i, t);
        }
        chunk.feet.resize(chunk.near.particle.size());
    });
}

void SurfaceContacts::append_row(int i, core::ContactHistory& history) const
{
    const std::size_t c = index_of(i / core::particles_per_chunk);
    if (c >= chunks_.size()) return;
    const auto& contacts = chunks_[c].contacts;
    auto contact = std::lower_bound(contacts.begin(), contacts.end(), i,
                                    [](const Contact& a, int particle) { return a.particle < particle; });
    std::int64_t k = first_feature;
    for (; contact != contacts.end() && contact->particle == i; ++contact) {
        if (contact->spring.isZero(0.0)) continue;
        history.add(core::wall_key(k++), spring_of(contact->spring));
        history.add(core::wall_key(k++), spring_of(contact->normal));
    }
}

void SurfaceContacts::find_feet(const core::ParticleSet& p, double half_step, Chunk& chunk) const
{
    const ParticleColumns columns(p);
    const int pairs = chunk.near.size();
    PatchBlock block;
    FootLanes lanes;
    for (int begin = 0; begin < pairs; begin += block_size) {
        const int count = std::min(block_size, pairs - begin);
        const int* particle = chunk.near.particle.data() + begin;
        Foot* feet = chunk.feet.data() + begin;
        block.read(surface_.patches().data(), chunk.near.triangle.data() + begin, count);
        for (int k = 0; k < count; ++k) {
            const auto i = index_of(particle[k]);
            lanes.x[k] = columns.x[i];
            lanes.y[k] = columns.y[i];
            lanes.z[k] = columns.z[i];
            lanes.wx[k] = half_step * columns.vx[i];
            lanes.wy[k] = half_step * columns.vy[i];
            lanes.wz[k] = half_step * columns.vz[i];
        }
        evaluate_feet(block, count, lanes);
        for (int k = 0; k < count; ++k)
            feet[k] = {{lanes.one[k], lanes.two[k], lanes.nx[k], lanes.ny[k], lanes.nz[k], lanes.depth[k]}, lanes.bx[k], lanes.by[k], lanes.bz[k]};
    }
}

/// Touches of the particle of near pairs [begin, end), the deepest first.
void SurfaceContacts::touch_one(const Vec3& centre, double radius, int begin, int end, Chunk& chunk) const
{
    auto& touches = chunk.touches;
    const auto first = std::ptrdiff_t(touches.size());
    SurfaceHit hit;
    for (int m = begin; m < end; ++m) {
        const Foot& foot = chunk.feet[index_of(m)];
        if (!surface_.meet(chunk.near.triangle[index_of(m)], foot.now, centre, hit) || std::abs(hit.depth) >= radius) continue;
        const Vec3 now(foot.now.nx, foot.now.ny, foot.now.nz), before(foot.before_x, foot.before_y, foot.before_z);
        Touch touch{chunk.near.particle[index_of(m)], hit, (hit.normal + before - now).normalized(), Vec3::Zero()};
        // a place of its own behind all that are not less deep
        auto place = touches.end();
        while (place != touches.begin() + first && hit.depth < (place - 1)->hit.depth) --place;
        touches.insert(place, touch);
    }
    if (std::ptrdiff_t(touches.size()) - first < 2) return;
    // a centre behind one face but before another is outside an edge, not inside the wall
    if (touches.back().hit.depth > 0.0)
        touches.erase(touches.begin() + first,
                      std::find_if(touches.begin() + first, touches.end(), [](const Touch& t) { return t.hit.depth > 0.0; }));
    auto kept = touches.begin() + first;
    for (auto t = kept; t != touches.end(); ++t) {
        const auto same = [&](const Touch& other) { return other.hit.normal.dot(t->hit.normal) > same_contact; };
        if (std::none_of(touches.begin() + first, kept, same)) *kept++ = *t;
    }
    touches.erase(kept, touches.end());
}

void SurfaceContacts::find_touches(const core::ParticleSet& p, Chunk& chunk) const
{
    chunk.touches.clear();
    auto old = chunk.contacts.begin();
    const int pairs = chunk.near.size();
    for (int begin = 0, end = 0; begin < pairs; begin = end) {
        const int i = chunk.near.particle[index_of(begin)];
        while (end < pairs && chunk.near.particle[index_of(end)] == i) ++end;
        const auto first = chunk.touches.size();
        touch_one(p.position_of(i), p.radius[index_of(i)], begin, end, chunk);
        while (old != chunk.contacts.end() && old->particle < i) ++old;
        auto old_end = old;
        while (old_end != chunk.contacts.end() && old_end->particle == i) ++old_end;
        for (auto t = first; t < chunk.touches.size(); ++t)
            chunk.touches[t].spring = take_spring(old, old_end, -chunk.touches[t].hit.normal);
        old = old_end;
    }
    chunk.contacts.resize(chunk.touches.size());
}

void SurfaceContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk_number, ForceSums& sums)
{
    Chunk& chunk = chunks_[index_of(chunk_number)];
    find_feet(p, 0.5 * laws.front().step, chunk);
    find_touches(p, chunk);
    const ParticleColumns columns(p);
    const SumColumns add(sums);
    for (std::size_t c = 0; c < chunk.touches.size(); ++c) {
        const Touch& touch = chunk.touches[c];
        const auto i = index_of(touch.particle);
        const LinearContact& law = laws.size() == 1 ? laws.front() : laws[index_of(p.species[i])];
        const WallMeeting at = meeting(-touch.hit.normal, -touch.normal_before, touch.hit.depth);
        ContactInput in = wall_input(columns, i, at);
        in.sx = touch.spring[0];
        in.sy = touch.spring[1];
        in.sz = touch.spring[2];
        const ContactOutput out = law(in);
        chunk.contacts[c] = {touch.particle, -touch.hit.normal, Vec3(out.sx, out.sy, out.sz)};
        add_wall_force(out, at, i - index_of(sums.begin), add);
    }
}

} // namespace physics

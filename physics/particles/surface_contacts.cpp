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

constexpr auto index_of(int i) { return std::size_t(i); }

} // namespace

void SurfaceContacts::build(const core::ParticleSet& particles, double skin, const core::ContactHistory& history)
{
    neighbours_.clear();
    chunk_begin_.clear();
    triangles_.clear();
    std::vector<int> found;
    for (int i = 0; i < particles.owned; ++i) {
        if (i % core::particles_per_chunk == 0) chunk_begin_.push_back(int(neighbours_.size()));
        surface_.candidates(particles.position_of(i), particles.radius[index_of(i)] + skin, found);
        if (found.empty()) continue;
        Neighbour n;
        n.particle = i;
        n.begin = int(triangles_.size());
        triangles_.insert(triangles_.end(), found.begin(), found.end());
        n.end = int(triangles_.size());
        for (std::int64_t k = 0;; ++k) {
            const auto s = history.find(i, core::wall_key(first_feature + k));
            if (s == core::Spring{0.0, 0.0, 0.0}) break;
            n.contacts.push_back({Vec3::Zero(), Vec3(s[0], s[1], s[2])});
        }
        neighbours_.push_back(std::move(n));
    }
    chunk_begin_.push_back(int(neighbours_.size()));
    near_.resize(triangles_.size());
}

void SurfaceContacts::refresh(const core::ParticleSet& particles, double skin, const core::Team& team)
{
    core::for_chunks(team, int(neighbours_.size()), core::particles_per_chunk, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {
            auto& n = neighbours_[index_of(k)];
            const Vec3 centre = particles.position_of(n.particle);
            n.near_end = n.begin;
            for (int t = n.begin; t < n.end; ++t)
                if (surface_.near(triangles_[index_of(t)], centre, particles.radius[index_of(n.particle)] + skin))
                    near_[index_of(n.near_end++)] = triangles_[index_of(t)];
        }
    });
}

void SurfaceContacts::append_row(int i, core::ContactHistory& history) const
{
    const auto found = std::lower_bound(neighbours_.begin(), neighbours_.end(), i,
                                        [](const Neighbour& n, int particle) { return n.particle < particle; });
    if (found == neighbours_.end() || found->particle != i) return;
    std::int64_t k = first_feature;
    for (const auto& contact : found->contacts)
        if (!contact.spring.isZero(0.0))
            history.add(core::wall_key(k++), {contact.spring[0], contact.spring[1], contact.spring[2]});
}

void SurfaceContacts::find_hits(const Vec3& centre, double radius, const Neighbour& neighbour, std::vector<SurfaceHit>& hits) const
{
    hits.clear();
    SurfaceHit hit;
    for (int k = neighbour.begin; k < neighbour.near_end; ++k)
        if (surface_.meet(near_[index_of(k)], centre, hit) && hit.depth < radius && hit.depth > -radius) hits.push_back(hit);
    // a centre behind one face but before another is outside an edge, not inside the wall
    if (std::any_of(hits.begin(), hits.end(), [](const SurfaceHit& h) { return h.depth > 0.0; }))
        std::erase_if(hits, [](const SurfaceHit& h) { return h.depth <= 0.0; });
    std::stable_sort(hits.begin(), hits.end(), [](const SurfaceHit& a, const SurfaceHit& b) { return a.depth < b.depth; });
    std::size_t kept = 0;
    for (std::size_t h = 0; h < hits.size(); ++h) {
        const auto same = [&](const SurfaceHit& other) { return other.normal.dot(hits[h].normal) > same_contact; };
        if (std::none_of(hits.begin(), hits.begin() + std::ptrdiff_t(kept), same)) hits[kept++] = hits[h];
    }
    hits.resize(kept);
}

Vec3 SurfaceContacts::take_spring(std::vector<Contact>& old, const Vec3& normal)
{
    std::size_t best = old.size();
    double likeness = same_friction;
    for (std::size_t k = 0; k < old.size(); ++k) {
        const bool known = !old[k].normal.isZero(0.0);
        const double like = known ? old[k].normal.dot(normal) : 1.0 - std::abs(old[k].spring.dot(normal)) / old[k].spring.norm();
        if (like > likeness) {
            likeness = like;
            best = k;
        }
    }
    if (best == old.size()) return Vec3::Zero();
    const Vec3 spring = old[best].spring;
    old.erase(old.begin() + std::ptrdiff_t(best));
    return spring;
}

void SurfaceContacts::add_forces(const core::ParticleSet& p, const ContactLaws& laws, int chunk, ForceSums& sums)
{
    const ParticleColumns columns(p);
    const SumColumns add(sums);
    std::vector<SurfaceHit> hits;
    std::vector<Contact> old;
    for (int k = chunk_begin_[index_of(chunk)]; k < chunk_begin_[index_of(chunk) + 1]; ++k) {
        auto& n = neighbours_[index_of(k)];
        if (n.near_end == n.begin) continue;
        const auto i = index_of(n.particle);
        const Vec3 centre = p.position_of(n.particle);
        find_hits(centre, p.radius[i], n, hits);
        old.swap(n.contacts);
        n.contacts.clear();
        const LinearContact& law = laws.size() == 1 ? laws.front() : laws[index_of(p.species[i])];
        for (const auto& hit : hits) {
            const Vec3 way = 0.5 * law.step * p.velocity_of(n.particle);
            const WallMeeting at = meeting(-hit.normal, -surface_.normal_before(hit, centre, way), hit.depth);
            const Vec3 spring = take_spring(old, -hit.normal);
            ContactInput in = wall_input(columns, i, at);
            in.sx = spring[0];
            in.sy = spring[1];
            in.sz = spring[2];
            const ContactOutput out = law(in);
            n.contacts.push_back({-hit.normal, Vec3(out.sx, out.sy, out.sz)});
            add_wall_force(out, at, i - index_of(sums.begin), add);
        }
    }
}

} // namespace physics

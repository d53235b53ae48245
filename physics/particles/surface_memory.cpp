// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// SurfaceContacts: what contacts remember from step to step, and through rebuilds.
#include "physics/particles/surface_contacts.hpp"

#include <algorithm>

namespace physics {
namespace {

using core::Vec3;

constexpr double same_friction = 0.7071;        // cosine of 45 degrees: a contact goes on
constexpr std::int64_t first_feature = 1 << 20; // analytic walls have lower numbers; each surface has as many
constexpr auto index_of(int i) { return std::size_t(i); }

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

void SurfaceContacts::recall(int i, const core::ContactHistory& history, Chunk& chunk) const
{
    for (std::int64_t k = first_feature * (1 + place_.number);; k += 2) {
        const core::Spring spring = history.find(i, core::wall_key(k));
        if (spring == core::Spring{}) break;
        chunk.contacts.push_back({i, vector_of(history.find(i, core::wall_key(k + 1))), vector_of(spring)});
        if (history.width == core::rolling_memory) chunk.turns.push_back(turn_of(spring));
    }
}

void SurfaceContacts::append_row(int i, core::ContactHistory& history) const
{
    const std::size_t c = index_of(i / core::particles_per_chunk);
    if (c >= chunks_.size()) return;
    const Chunk& chunk = chunks_[c];
    const auto& contacts = chunk.contacts;
    auto contact =
        std::lower_bound(contacts.begin(), contacts.end(), i, [](const Contact& a, int particle) { return a.particle < particle; });
    std::int64_t k = first_feature * (1 + place_.number);
    for (; contact != contacts.end() && contact->particle == i; ++contact) {
        core::Spring spring = spring_of(contact->spring);
        if (!chunk.turns.empty())
            for (int a = 0; a < 3; ++a) spring[index_of(3 + a)] = chunk.turns[std::size_t(contact - contacts.begin())][a];
        if (spring == core::Spring{}) continue;
        history.add(core::wall_key(k++), spring);
        history.add(core::wall_key(k++), spring_of(contact->normal));
    }
}

} // namespace physics

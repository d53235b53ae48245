// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.hpp"
#include "core/particles/chunk_windows.hpp"
#include "tests/support/listed_pairs.hpp"
#include <doctest/doctest.h>

#include <algorithm>

namespace {

using core::Vec3;

/// Spheres at random in a long periodic box, sorted along it.
core::PairList pairs_in_a_row(int n)
{
    constexpr double radius = 0.05, skin = 0.02;
    const core::Domain domain{Vec3::Zero(), Vec3(20.0, 0.5, 0.5), {true, true, true}};
    core::ParticleSet set;
    for (int k = 0; k < n; ++k) {
        const auto u = core::random_uniform(5, k, 0);
        core::Sphere s;
        s.id = k;
        s.density = 1.0;
        s.radius = radius;
        s.position = Vec3(u[0] * 20.0, u[1] * 0.5, u[2] * 0.5);
        set.add(s);
    }
    core::Octaves octaves{};
    octaves[std::size_t(core::octave_of(radius))] = radius;
    const auto bins = core::make_level_bins(domain, {Vec3::Zero(), domain.size}, core::SizeLevels(octaves), skin, n);
    set.reorder(core::order_by_bin(set, bins.finest()));
    return test::listed_pairs(set, bins, skin);
}

/// Chunks as equal segments run them, of which those wait that pairs of earlier segments touch.
core::ChunkPlan plan_of(const core::PairList& pairs, int segments)
{
    core::ChunkPlan plan{{}, std::vector<char>(std::size_t(pairs.chunks()), 0)};
    for (int s = 0; s <= segments; ++s) plan.segments.push_back(pairs.chunks() * s / segments);
    for (std::size_t s = 0; s + 1 < plan.segments.size(); ++s)
        for (int c = plan.segments[s]; c < plan.segments[s + 1]; ++c)
            for (const int reader : pairs.links[std::size_t(c)])
                if (reader >= plan.segments[s + 1]) plan.deferred[std::size_t(reader)] = 1;
    return plan;
}

/// Whose results each slot holds while chunks run in an order.
struct Slots {
    const core::PairList& pairs;
    const core::PairSlots& slots;
    std::vector<int> holder;

    void write(int chunk)
    {
        for (int p = pairs.chunk_begin[std::size_t(chunk)]; p < pairs.chunk_begin[std::size_t(chunk) + 1]; ++p)
            holder.at(std::size_t(p + slots.offset[std::size_t(chunk)])) = chunk;
    }
    [[nodiscard]] bool hold(int chunk) const
    {
        bool all = true;
        for (int p = pairs.chunk_begin[std::size_t(chunk)]; p < pairs.chunk_begin[std::size_t(chunk) + 1]; ++p)
            all = all && holder.at(std::size_t(p + slots.offset[std::size_t(chunk)])) == chunk;
        return all;
    }
    /// Reader r finds what it needs.
    void read(int r) const
    {
        for (int c = 0; c <= r; ++c) {
            const auto& links = pairs.links[std::size_t(c)];
            if (c == r || std::binary_search(links.begin(), links.end(), r)) CHECK(hold(c));
        }
    }
};

} // namespace

TEST_CASE("results of pairs stay in their slots until all who read them have moved, whichever segment is first")
{
    const core::PairList pairs = pairs_in_a_row(6000);
    REQUIRE(pairs.chunks() > 20);
    for (const int segments : {1, 2, 5})
        for (const bool backwards : {false, true}) {
            const core::ChunkPlan plan = plan_of(pairs, segments);
            core::PairSlots slots;
            slots.plan(pairs, plan);
            Slots state{pairs, slots, std::vector<int>(std::size_t(slots.count), -1)};
            for (int n = 0; n < segments; ++n) {
                const auto s = std::size_t(backwards ? segments - 1 - n : n);
                for (int c = plan.segments[s]; c < plan.segments[s + 1]; ++c) {
                    state.write(c);
                    if (!plan.deferred[std::size_t(c)]) state.read(c);
                }
            }
            for (int c = 0; c < pairs.chunks(); ++c)
                if (plan.deferred[std::size_t(c)]) state.read(c);
        }
}

TEST_CASE("one thread needs slots for a few chunks, not for all")
{
    const core::PairList pairs = pairs_in_a_row(6000);
    core::PairSlots slots;
    slots.plan(pairs, plan_of(pairs, 1));
    CHECK(slots.count < pairs.size() / 2); // the first chunk is read by the last, through the periodic sides, and keeps its own
}

TEST_CASE("pairs find the copies of all particles that they read, ghosts too, in few places")
{
    const core::PairList pairs = pairs_in_a_row(6000);
    constexpr int size = core::particles_per_chunk, owned = 6000, ghosts = 700; // the last chunk of owned ones has ghosts, too
    for (const int segments : {1, 2, 5}) {
        const core::ChunkPlan plan = plan_of(pairs, segments);
        core::ChunkWindows windows;
        windows.plan(pairs, plan, owned, ghosts);
        std::vector<int> holder(std::size_t(windows.count), -1); // the chunk whose copies a place holds
        const auto place = [&](int segment, int i) { return i + windows.offset[std::size_t(segment)][std::size_t(i / size)]; };
        for (int i = windows.first_ghost; i < owned + ghosts; ++i) holder.at(std::size_t(place(0, i))) = i / size;
        for (int s = 0; s < segments; ++s)
            for (int c = plan.segments[std::size_t(s)]; c < plan.segments[std::size_t(s) + 1]; ++c) {
                for (const int next : windows.enter[std::size_t(c)])
                    for (int i = next * size; i < std::min(owned + ghosts, next * size + size); ++i)
                        holder.at(std::size_t(place(s, i))) = next;
                const auto holds = [&](int i) { return holder.at(std::size_t(place(s, i))) == i / size; };
                for (int p = pairs.chunk_begin[std::size_t(c)]; p < pairs.chunk_begin[std::size_t(c) + 1]; ++p) {
                    CHECK(holds(pairs.first[std::size_t(p)]));
                    CHECK(holds(pairs.second[std::size_t(p)]));
                }
                CHECK(holds(owned));
                CHECK(holds(owned + ghosts - 1));
            }
        if (segments == 1) CHECK(windows.count - ghosts < owned / 2); // the last chunk is read by the first, through the periodic sides
    }
}

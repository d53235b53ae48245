// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.hpp"
#include "core/particles/ghosts.hpp"
#include "tests/support/listed_pairs.hpp"
#include <doctest/doctest.h>

#include <set>

namespace {

using core::Vec3;
using Key = std::pair<std::int64_t, std::int64_t>;

constexpr double small = 0.008, large = 0.16, skin = 0.003;
const core::Domain domain{Vec3::Zero(), Vec3::Constant(1.0), {true, false, true}};

std::vector<core::Sphere> all_spheres()
{
    std::vector<core::Sphere> all;
    for (int k = 0; k < 4000; ++k) {
        const auto u = core::random_uniform(5, k, 0);
        core::Sphere s;
        s.id = k;
        s.density = 1.0;
        s.radius = k % 800 == 0 ? large : small;
        s.position = Vec3(u[0], u[1], u[2]);
        all.push_back(s);
    }
    return all;
}

/// Four ranks own the quarters along y.
int owner_of(const core::Sphere& s) { return int(4 * s.position.y()); }

core::LevelBins bins_of(const std::vector<core::Sphere>& all)
{
    core::Octaves octaves{};
    for (const core::Sphere& s : all) {
        double& greatest = octaves[std::size_t(core::octave_of(s.radius))];
        greatest = std::max(greatest, s.radius);
    }
    return core::make_level_bins(domain, {Vec3::Zero(), domain.size}, core::SizeLevels(octaves), skin, std::int64_t(all.size()));
}

std::vector<core::ParticleSet> with_ghosts(const std::vector<core::Sphere>& all, const core::LevelBins& bins)
{
    std::vector<core::ParticleSet> ranks(4);
    for (const core::Sphere& s : all) ranks[std::size_t(owner_of(s))].add(s);
    std::vector<std::vector<std::int64_t>> wanted;
    for (const auto& set : ranks) wanted.push_back(core::bins_of_interest(set, bins));
    std::vector<std::vector<std::vector<std::byte>>> for_rank(4, std::vector<std::vector<std::byte>>(4));
    for (int from = 0; from < 4; ++from) {
        auto others = wanted;
        others[std::size_t(from)].clear();
        core::Ghosts ghosts;
        ghosts.choose(ranks[std::size_t(from)], bins, others);
        for (int to = 0; to < 4; ++to) for_rank[std::size_t(to)][std::size_t(from)] = ghosts.describe(ranks[std::size_t(from)], to);
    }
    for (std::size_t r = 0; r < 4; ++r) core::Ghosts().adopt(for_rank[r], ranks[r]);
    return ranks;
}

std::set<Key> listed(const core::ParticleSet& set, const core::LevelBins& bins)
{
    const core::PairList pairs = test::listed_pairs(set, bins, skin);
    std::set<Key> keys;
    for (int c = 0; c < pairs.chunks(); ++c)
        for (int p = pairs.chunk_begin[std::size_t(c)]; p < pairs.chunk_begin[std::size_t(c) + 1]; ++p) {
            const int a = pairs.first[std::size_t(p)], b = pairs.second[std::size_t(p)];
            CHECK(std::min(a, b) / core::particles_per_chunk == c); // the chunk of the one that comes first
            CHECK(keys.insert({set.id[std::size_t(a)], set.id[std::size_t(b)]}).second);
        }
    return keys;
}

} // namespace

TEST_CASE("each rank lists all close pairs of its spheres 1:20 with its own and with ghosts, and no other")
{
    const auto all = all_spheres();
    const core::LevelBins bins = bins_of(all);
    REQUIRE(bins.sizes.count() == 2);
    const auto ranks = with_ghosts(all, bins);
    std::vector<std::set<Key>> wanted(4);
    for (const core::Sphere& a : all)
        for (const core::Sphere& b : all) {
            if (a.id >= b.id) continue;
            Vec3 d = b.position - a.position;
            for (const int axis : {0, 2}) d[axis] -= std::round(d[axis]);
            if (d.norm() >= a.radius + b.radius + skin) continue;
            wanted[std::size_t(owner_of(a))].insert({a.id, b.id});
            wanted[std::size_t(owner_of(b))].insert({a.id, b.id});
        }
    for (std::size_t r = 0; r < 4; ++r) {
        const auto found = listed(ranks[r], bins);
        // Single precision may list a pair more that is at the very end of the reach, never one less.
        CHECK(std::includes(found.begin(), found.end(), wanted[r].begin(), wanted[r].end()));
        CHECK(found.size() <= wanted[r].size() + 3);
    }
}

TEST_CASE("small spheres are ghosts where they are near the border or a large sphere, not wherever a large one would reach")
{
    const auto all = all_spheres();
    const auto ranks = with_ghosts(all, bins_of(all));
    // A layer of one or two bins of 0.32 m is all of the two neighbours' quarters: 2000 spheres. Layers of two small bins hold 2 x 4 % of
    // 4000, and each of the one or two large spheres near a border has up to 3 x 3 x 3 bins of 0.33 m.
    int most = 0;
    for (const auto& set : ranks) most = std::max(most, set.ghosts());
    CHECK(most < 3000); // the large spheres of this scene are near borders
    std::vector<core::Sphere> fine = all;
    std::erase_if(fine, [](const core::Sphere& s) { return s.radius == large && s.position.y() > 0.25; });
    const auto few = with_ghosts(fine, bins_of(fine));
    CHECK(few[3].ghosts() < 500); // two layers of two bins, and one large sphere far away
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.hpp"
#include "core/particles/near_pairs.hpp"
#include "tests/support/listed_pairs.hpp"
#include <doctest/doctest.h>

#include <set>

namespace {

using core::Vec3;
using Key = std::pair<std::int64_t, std::int64_t>;

core::ParticleSet random_spheres(int n, const Vec3& box, double small, double large)
{
    core::ParticleSet set;
    for (int k = 0; k < n; ++k) {
        const auto u = core::random_uniform(3, k, 0);
        core::Sphere s;
        s.id = k;
        s.density = 1.0;
        s.radius = k % 50 == 0 ? large : small;
        s.position = Vec3(u[0] * box[0], u[1] * box[1], u[2] * box[2]);
        set.add(s);
    }
    return set;
}

/// All pairs closer than touching + skin, by brute force over the nearest images.
std::set<Key> brute_force(const core::ParticleSet& p, const core::Domain& domain, double skin)
{
    std::set<Key> pairs;
    for (int i = 0; i < p.owned; ++i)
        for (int j = i + 1; j < p.owned; ++j) {
            Vec3 d = p.position_of(j) - p.position_of(i);
            for (int a = 0; a < 3; ++a)
                if (domain.periodic[std::size_t(a)]) d[a] -= domain.size[a] * std::round(d[a] / domain.size[a]);
            const auto ii = std::size_t(i), jj = std::size_t(j);
            if (d.norm() < p.radius[ii] + p.radius[jj] + skin) pairs.insert({std::min(p.id[ii], p.id[jj]), std::max(p.id[ii], p.id[jj])});
        }
    return pairs;
}

void compare(const core::Domain& domain, double small, double large)
{
    auto set = random_spheres(900, domain.size, small, large);
    const double skin = 0.3 * small, margin = 1e-9;
    const core::Bounds bounds{Vec3::Zero(), domain.size};
    core::Octaves octaves{};
    for (const double r : set.radius) octaves[std::size_t(core::octave_of(r))] = std::max(octaves[std::size_t(core::octave_of(r))], r);
    const core::SizeLevels sizes(octaves);
    CHECK(sizes.count() == (large > 2 * small ? 2 : 1));
    const auto bins = core::make_level_bins(domain, bounds, sizes, skin, set.owned);
    set.reorder(core::order_by_bin(set, bins.finest()));
    core::PairList pairs = test::listed_pairs(set, bins, skin);
    core::NearPairs near;
    core::ContactHistory none;
    for (int i = 0; i < set.owned; ++i) none.end_row();
    const auto shifts = core::image_shifts(domain);
    core::PairSlots slots;
    slots.keep_all(pairs);
    near.start({set, pairs, shifts, skin - margin, slots}, none, core::SerialTeam{});
    std::set<Key> listed, near_listed;
    for (int p = 0; p < pairs.size(); ++p) {
        const Key key{set.id[std::size_t(pairs.first[std::size_t(p)])], set.id[std::size_t(pairs.second[std::size_t(p)])]};
        CHECK(key.first < key.second);
        CHECK(listed.insert(key).second); // each pair once
    }
    for (int c = 0; c < pairs.chunks(); ++c)
        for (const auto& run : near.runs[std::size_t(c)])
            for (int m = run.begin; m < run.end; ++m)
                near_listed.insert({set.id[std::size_t(pairs.first[std::size_t(m)])], set.id[std::size_t(pairs.second[std::size_t(m)])]});
    const auto wanted = brute_force(set, domain, skin - margin);
    for (const auto& key : wanted) CHECK(listed.count(key) == 1);
    CHECK(near_listed == wanted);
}

} // namespace

TEST_CASE("the lists hold all close pairs of an open box")
{
    compare({Vec3::Zero(), Vec3(1.0, 0.4, 0.2), {false, false, false}}, 0.02, 0.03);
}

TEST_CASE("the lists hold all close pairs across periodic sides, also with two bins")
{
    compare({Vec3::Zero(), Vec3(1.0, 0.4, 0.14), {true, false, true}}, 0.02, 0.03);
    compare({Vec3::Zero(), Vec3(0.5, 0.5, 0.5), {true, true, true}}, 0.015, 0.02);
}

TEST_CASE("the lists hold all close pairs of spheres 1:20")
{
    compare({Vec3::Zero(), Vec3(1.0, 1.0, 1.0), {false, true, false}}, 0.01, 0.2);
    compare({Vec3::Zero(), Vec3(1.0, 1.0, 1.0), {true, true, true}}, 0.004, 0.2);
}

TEST_CASE("radii within a factor of two are one level, whatever octaves they fall into")
{
    const auto levels = [](std::vector<double> radii) {
        core::Octaves octaves{};
        for (const double r : radii) octaves[std::size_t(core::octave_of(r))] = std::max(octaves[std::size_t(core::octave_of(r))], r);
        return core::SizeLevels(octaves);
    };
    CHECK(levels({1e-3}).count() == 1);
    CHECK(levels({0.9e-3, 1.1e-3}).count() == 1); // 2^-10 lies between them
    CHECK(levels({1e-3, 1.5e-3}).count() == 1);
    const core::SizeLevels wide = levels({1e-3, 3e-3, 5e-2});
    CHECK(wide.count() == 3);
    CHECK(wide.level_of(5e-2) == 0);
    CHECK(wide.level_of(3e-3) == 1);
    CHECK(wide.level_of(1e-3) == 2);
    CHECK(wide.greatest(1) == 3e-3);
    CHECK(levels({}).count() == 1);
}

TEST_CASE("histories keep springs by id, also of walls")
{
    core::ContactHistory history;
    history.add(4, {1, 2, 3});
    history.end_row();
    history.add(core::wall_key(0), {5, 0, 0});
    history.end_row();
    const int order[] = {1, 0};
    history.reorder(order);
    CHECK(history.find(0, core::wall_key(0))[0] == 5);
    CHECK(history.find(1, 4)[2] == 3);
    CHECK(history.find(1, 5)[2] == 0);
}

TEST_CASE("coordinates wrap into the box, never onto its upper end")
{
    const core::Domain domain{Vec3::Zero(), Vec3(1, 1, 1), {true, false, false}};
    CHECK(domain.wrapped(0, -1e-30) == 0.0);
    CHECK(domain.wrapped(0, 1.25) == 0.25);
    CHECK(domain.wrapped(1, 1.25) == 1.25);
}

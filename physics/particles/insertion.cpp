// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/insertion.hpp"
#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "core/grid/extents.hpp"
#include "physics/particles/overlap_relaxation.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

namespace physics {
namespace {

constexpr int most_trials = 20000;
constexpr std::uint64_t order_draw = std::uint64_t(1) << 40; // a draw that no trial uses
constexpr std::uint64_t size_draw = order_draw + 2;          // and one for each group after it

/// The spheres placed so far in bins of one largest diameter, so that only near ones are compared.
class Placed {
public:
    Placed(const core::Domain& domain, double largest_diameter) : domain_(domain)
    {
        for (int a = 0; a < 3; ++a) {
            count_[std::size_t(a)] = std::max(1, int(domain.size[a] / largest_diameter));
            edge_[a] = domain.size[a] / count_[std::size_t(a)];
        }
    }

    void add(const core::Vec3& x, double radius) { bins_[bin(x)].push_back({x, radius}); }

    [[nodiscard]] bool free(const core::Vec3& x, double radius) const
    {
        const auto home = bin(x);
        bool clear = true;
        core::for_each({-1, -1, -1}, {2, 2, 2}, [&](int i, int j, int k) {
            std::array<int, 3> at{home[0] + i, home[1] + j, home[2] + k};
            for (std::size_t a = 0; a < 3; ++a)
                if (domain_.periodic[a]) at[a] = (at[a] + count_[a]) % count_[a];
            const auto found = bins_.find(at);
            if (found == bins_.end()) return;
            for (const Ball& ball : found->second) clear = clear && separation(ball.centre - x).norm() >= radius + ball.radius;
        });
        return clear;
    }

private:
    struct Ball {
        core::Vec3 centre;
        double radius;
    };
    [[nodiscard]] std::array<int, 3> bin(const core::Vec3& x) const
    {
        std::array<int, 3> at{};
        for (int a = 0; a < 3; ++a) at[std::size_t(a)] = std::clamp(int(x[a] / edge_[a]), 0, count_[std::size_t(a)] - 1);
        return at;
    }
    [[nodiscard]] core::Vec3 separation(core::Vec3 d) const
    {
        for (int a = 0; a < 3; ++a)
            if (domain_.periodic[std::size_t(a)]) d[a] -= domain_.size[a] * std::round(d[a] / domain_.size[a]);
        return d;
    }

    const core::Domain& domain_;
    std::array<int, 3> count_{};
    core::Vec3 edge_;
    std::map<std::array<int, 3>, std::vector<Ball>> bins_;
};

/// Numbers of `count` spheres, in the random order of draw number `draw`.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t draw)
{
    std::vector<double> place(count);
    for (std::size_t n = 0; n < count; ++n) place[n] = core::random_uniform(seed, std::int64_t(n), draw)[0];
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
    return order;
}

/// One sphere for each particle wanted, without a place.
std::vector<std::pair<core::Sphere, Region>> wanted(const std::vector<Group>& groups, std::uint64_t seed)
{
    std::vector<std::pair<core::Sphere, Region>> all;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto dealt = shuffled(groups[g].radii.size(), seed, size_draw + g);
        for (int n = 0; n < groups[g].count; ++n) {
            core::Sphere sphere = groups[g].like;
            sphere.id = std::int64_t(all.size());
            if (!dealt.empty()) sphere.radius = groups[g].radii.at(dealt[std::size_t(n)]);
            all.emplace_back(sphere, groups[g].region);
        }
    }
    return all;
}

double largest_radius(const std::vector<std::pair<core::Sphere, Region>>& all)
{
    double largest = 0.0;
    for (const auto& [sphere, region] : all) largest = std::max(largest, sphere.radius);
    return largest;
}

void require_all_placed(std::size_t placed, std::size_t wanted)
{
    core::require<core::ConfigError>(placed == wanted, core::text("a lattice has room for ", placed, " of ", wanted,
                                                                  " particles: use fewer or smaller ones, or a larger region"));
}

/// Layers of face-centred cubes along an axis: half an edge apart.
struct Layers {
    int count;
    double first, gap; ///< [m]
    [[nodiscard]] double at(int layer) const { return first + layer * gap; }
};

Layers layers_of(const core::Domain& domain, int axis, double diameter, double spacing)
{
    const double half_edge = spacing * diameter / std::numbers::sqrt2, size = domain.size[axis];
    if (domain.periodic[std::size_t(axis)]) {
        const int count = 2 * std::max(1, int(std::lround(0.5 * size / half_edge)));
        return {count, 0.5 * size / count, size / count};
    }
    // Four neighbours push with the overlap (1 - spacing) d each, across a layer by its share 1 / sqrt 2; walls do not pull.
    const double clear = (0.5 - 2.0 * std::numbers::sqrt2 * std::max(0.0, 1.0 - spacing)) * diameter,
                 between = std::max(0.0, size - 2.0 * clear);
    const int gaps = int(std::lround(between / half_edge));
    return {gaps + 1, gaps > 0 ? clear : 0.5 * size, gaps > 0 ? between / gaps : 0.0};
}

} // namespace

std::vector<core::Sphere> place_at_random(const core::Domain& domain, const Obstacles& obstacles, const std::vector<Group>& groups,
                                          std::uint64_t seed)
{
    auto all = wanted(groups, seed);
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a].first.radius > all[b].first.radius; });
    Placed placed(domain, 2.0 * largest_radius(all));
    for (const std::size_t n : order) {
        auto& [sphere, region] = all[n];
        bool found = false;
        for (int trial = 0; trial < most_trials && !found; ++trial) {
            const auto u = core::random_uniform(seed, sphere.id, std::uint64_t(trial));
            sphere.position = point_in(region, core::Vec3(u[0], u[1], u[2]));
            found = obstacles.leave_room(sphere.position, sphere.radius) && placed.free(sphere.position, sphere.radius);
        }
        core::require<core::ConfigError>(found, core::text("no room for particle ", sphere.id, " of ", all.size(), " (diameter ",
                                                           2.0 * sphere.radius, " m) after ", most_trials,
                                                           " trials: use fewer particles, a larger region or a lattice"));
        placed.add(sphere.position, sphere.radius);
    }
    std::vector<core::Sphere> spheres;
    for (const auto& [sphere, region] : all) spheres.push_back(sphere);
    return spheres;
}

std::vector<core::Sphere> place_densely(const core::Domain& domain, const Obstacles& obstacles, const std::vector<Group>& groups,
                                        std::uint64_t seed)
{
    std::vector<core::Sphere> spheres;
    std::vector<Region> regions;
    for (auto& [sphere, region] : wanted(groups, seed)) {
        bool found = false;
        for (int trial = 0; trial < most_trials && !found; ++trial) {
            const auto u = core::random_uniform(seed, sphere.id, std::uint64_t(trial));
            sphere.position = point_in(region, core::Vec3(u[0], u[1], u[2]));
            found = obstacles.leave_room(sphere.position, sphere.radius);
        }
        core::require<core::ConfigError>(found, core::text("no place in its region is clear of the walls for particle ", sphere.id,
                                                           " (diameter ", 2.0 * sphere.radius, " m)"));
        spheres.push_back(sphere);
        regions.push_back(region);
    }
    relax_overlaps(domain, obstacles.walls, regions, spheres);
    return spheres;
}

std::vector<core::Sphere> place_on_lattice(const core::Domain& domain, const Obstacles& obstacles, const std::vector<Group>& groups,
                                           std::uint64_t seed)
{
    const auto all = wanted(groups, seed);
    const auto order = shuffled(all.size(), seed, order_draw);
    const double radius = largest_radius(all), edge = 2.02 * radius;
    core::Index3 count;
    for (int a = 0; a < 3; ++a) count[a] = std::max(1, int(domain.size[a] / edge));
    std::vector<core::Sphere> spheres(all.size());
    std::size_t next = 0;
    core::for_each({0, 0, 0}, count, [&](int i, int j, int k) {
        if (next == order.size()) return;
        core::Vec3 x((i + 0.5) * domain.size.x() / count.i, (j + 0.5) * domain.size.y() / count.j, (k + 0.5) * domain.size.z() / count.k);
        const auto& [sphere, region] = all[order[next]];
        if (!contains(region, x) || !obstacles.leave_room(x, radius)) return;
        // A little off the lattice, so that columns of particles do not stand on each other's heads.
        const auto u = core::random_uniform(seed, sphere.id, order_draw + 1);
        auto& place = spheres[order[next]];
        place = sphere;
        place.position = x + 0.005 * radius * core::Vec3(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5);
        ++next;
    });
    require_all_placed(next, order.size());
    return spheres;
}

std::vector<core::Sphere> place_packed(const core::Domain& domain, const std::vector<Group>& groups, double spacing, std::uint64_t seed)
{
    const auto all = wanted(groups, seed);
    const auto order = shuffled(all.size(), seed, order_draw);
    const double diameter = 2.0 * largest_radius(all);
    const std::array<Layers, 3> layers{layers_of(domain, 0, diameter, spacing), layers_of(domain, 1, diameter, spacing),
                                       layers_of(domain, 2, diameter, spacing)};
    std::size_t up = 0;
    while (up < 2 && domain.periodic[up]) ++up;
    const std::size_t across = (up + 1) % 3, along = (up + 2) % 3;
    std::vector<core::Sphere> spheres(all.size());
    std::size_t next = 0;
    for (int k = 0; k < layers[up].count; ++k)
        for (int j = 0; j < layers[across].count; ++j)
            for (int i = 0; i < layers[along].count && next < order.size(); ++i) {
                if ((i + j + k) % 2 != 0) continue;
                core::Vec3 x;
                x[int(up)] = layers[up].at(k);
                x[int(across)] = layers[across].at(j);
                x[int(along)] = layers[along].at(i);
                const auto& [sphere, region] = all[order[next]];
                if (!contains(region, x)) continue;
                spheres[order[next]] = sphere;
                spheres[order[next]].position = x;
                ++next;
            }
    require_all_placed(next, order.size());
    return spheres;
}

} // namespace physics

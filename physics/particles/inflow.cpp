// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/inflow.hpp"
#include "core/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace physics {
namespace {

constexpr int most_trials = 200;                            // in a step; the next one goes on with as many
constexpr std::uint64_t size_draw = std::uint64_t(1) << 41; // a draw that no trial uses

double amount_of(const core::Sphere& sphere, Inflow::Measure measure)
{
    if (measure == Inflow::Measure::number) return 1.0;
    return 4.0 / 3.0 * std::numbers::pi * std::pow(sphere.radius, 3) * sphere.density;
}

/// The way between two centres, to the nearest image.
core::Vec3 separation(const core::Domain& domain, core::Vec3 d)
{
    for (int a = 0; a < 3; ++a)
        if (domain.periodic[std::size_t(a)]) d[a] -= domain.size[a] * std::round(d[a] / domain.size[a]);
    return d;
}

bool is_free(const core::Sphere& sphere, const core::Domain& domain, const Obstacles& obstacles, const std::vector<core::Sphere>& near)
{
    if (!obstacles.leave_room(sphere.position, sphere.radius)) return false;
    return std::all_of(near.begin(), near.end(), [&](const core::Sphere& other) {
        return separation(domain, other.position - sphere.position).norm() >= sphere.radius + other.radius;
    });
}

} // namespace

std::vector<core::Sphere> entering(const Inflow& inflow, double time, const core::Domain& domain, const Obstacles& obstacles,
                                   std::uint64_t seed, std::vector<core::Sphere>& near, std::int64_t& next_id, Entered& entered)
{
    const double due = inflow.rate * std::clamp(time - inflow.begin, 0.0, inflow.end - inflow.begin) * (1 + 1e-12); // rounding of times
    std::vector<core::Sphere> all;
    for (;;) {
        core::Sphere sphere = inflow.like;
        sphere.id = next_id;
        sphere.radius = 0.5 * diameter_at(inflow.sizes, core::random_uniform(seed, next_id, size_draw)[0]);
        const double amount = amount_of(sphere, inflow.measure);
        bool found = false;
        for (int trial = 0; trial < most_trials && !found && entered.amount + amount <= due; ++trial) {
            const auto u = core::random_uniform(seed, next_id, std::uint64_t(trial));
            sphere.position = point_in(inflow.region, core::Vec3(u[0], u[1], u[2]));
            for (int a = 0; a < 3; ++a) sphere.position[a] = domain.wrapped(a, sphere.position[a]);
            found = is_free(sphere, domain, obstacles, near);
        }
        if (!found) return all;
        all.push_back(sphere);
        near.push_back(sphere);
        ++next_id;
        ++entered.count;
        entered.amount += amount;
    }
}

bool may_meet(const Inflow& inflow, const core::Domain& domain, const core::Vec3& centre, double radius)
{
    const double reach = radius + 0.5 * diameter_at(inflow.sizes, 1.0);
    const auto images = [&](int axis) { return domain.periodic[std::size_t(axis)] ? 1 : 0; };
    for (int i = -images(0); i <= images(0); ++i)
        for (int j = -images(1); j <= images(1); ++j)
            for (int k = -images(2); k <= images(2); ++k) {
                const core::Vec3 image = centre + core::Vec3(i, j, k).cwiseProduct(domain.size);
                if ((nearest_point(inflow.region, image) - image).norm() < reach) return true;
            }
    return false;
}

} // namespace physics

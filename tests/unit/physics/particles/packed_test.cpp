// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/particles/insertion.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

using core::Vec3;

namespace {

constexpr double diameter = 2e-3;

physics::Group group_of(const core::Domain& domain, int count)
{
    physics::Group group;
    group.like.radius = 0.5 * diameter;
    group.count = count;
    group.region = physics::BoxRegion{Vec3::Zero(), domain.size};
    return group;
}

double distance(const core::Domain& domain, Vec3 d)
{
    for (int a = 0; a < 3; ++a)
        if (domain.periodic[std::size_t(a)]) d[a] -= domain.size[a] * std::round(d[a] / domain.size[a]);
    return d.norm();
}

} // namespace

TEST_CASE("a packed bed has twelve neighbours at the distance asked for, and walls push as four of them do")
{
    const double spacing = 0.99, edge = std::numbers::sqrt2 * spacing * diameter;
    const double clear = 0.5 * diameter - 2 * std::numbers::sqrt2 * (1 - spacing) * diameter; // 4 / sqrt 2 overlaps of neighbours
    core::Domain domain;
    domain.periodic = {true, false, true};
    domain.size = {3 * edge, 1.5 * edge + 2 * clear, 2 * edge};
    const auto spheres = physics::place_packed(domain, {group_of(domain, 48)}, spacing, 1); // 3 x 2 x 2 cubes of four
    for (const core::Sphere& a : spheres) {
        int neighbours = 0, near = 0;
        for (const core::Sphere& b : spheres) {
            if (a.id == b.id) continue;
            const double r = distance(domain, a.position - b.position) / diameter;
            near += r < spacing * (1 - 1e-9) ? 1 : 0;
            neighbours += r < spacing * (1 + 1e-9) ? 1 : 0;
        }
        const double wall = std::min(a.position.y(), domain.size.y() - a.position.y());
        CHECK(near == 0);
        CHECK(neighbours == (wall < 1.01 * clear ? 8 : 12)); // four below are missing at a wall
        if (neighbours == 8) CHECK(wall == test::relative(clear).epsilon(1e-9));
    }
    CHECK_THROWS_AS((void)physics::place_packed(domain, {group_of(domain, 49)}, spacing, 1), core::ConfigError);
}

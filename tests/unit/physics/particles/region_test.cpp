// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.hpp"
#include "physics/particles/region.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

using core::Vec3;

TEST_CASE("points drawn in a region lie in it, evenly, and are their own nearest points")
{
    const Vec3 a(1, 2, 3), b(2, 4, 3.5);
    const std::vector<physics::Region> regions{physics::BoxRegion{a, b}, physics::CylinderRegion{a, b, 0.7}, physics::SphereRegion{a, 0.7}};
    for (const physics::Region& region : regions) {
        constexpr int count = 20000;
        const physics::Region wide = physics::grown(region, 0.2);
        int inside = 0;
        Vec3 middle = Vec3::Zero();
        for (int n = 0; n < count; ++n) {
            const auto u = core::random_uniform(1, n, 0);
            const Vec3 x = physics::point_in(region, Vec3(u[0], u[1], u[2])), y = physics::point_in(wide, Vec3(u[0], u[1], u[2]));
            REQUIRE((physics::nearest_point(region, x) - x).norm() < 1e-12); // rounding
            inside += physics::contains(region, y) ? 1 : 0;
            middle += y / count;
            const Vec3 back = physics::nearest_point(region, y);
            REQUIRE((physics::nearest_point(region, back) - back).norm() < 1e-12);
        }
        const double share = physics::volume_of(region) / physics::volume_of(wide);
        CHECK(std::abs(double(inside) / count - share) < 4 * std::sqrt(share / count)); // four standard deviations
        const Vec3 centre = std::holds_alternative<physics::SphereRegion>(region) ? a : Vec3(0.5 * (a + b));
        CHECK((middle - centre).norm() < 4 * 1.5 / std::sqrt(double(count))); // four of a box of 3 diagonal
    }
}

TEST_CASE("the nearest point of a cylinder is beside it on its mantle, before its ends on them")
{
    const physics::Region tube = physics::CylinderRegion{Vec3::Zero(), Vec3(0, 0, 2), 1.0};
    CHECK((physics::nearest_point(tube, Vec3(3, 0, 1)) - Vec3(1, 0, 1)).norm() < 1e-15);
    CHECK((physics::nearest_point(tube, Vec3(0.5, 0, 5)) - Vec3(0.5, 0, 2)).norm() < 1e-15);
    CHECK((physics::nearest_point(tube, Vec3(0, 3, -1)) - Vec3(0, 1, 0)).norm() < 1e-15);
}

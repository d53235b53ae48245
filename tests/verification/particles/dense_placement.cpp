// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Random packings up to random close packing, and starts whose overlaps are relaxed.
#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "physics/particles/insertion.hpp"
#include "physics/particles/overlap_relaxation.hpp"
#include "tests/support/particle_scene.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;

double gap(const core::Domain& domain, const core::Sphere& a, const core::Sphere& b)
{
    Vec3 d = a.position - b.position;
    for (int axis = 0; axis < 3; ++axis)
        if (domain.periodic[std::size_t(axis)]) d[axis] -= domain.size[axis] * std::round(d[axis] / domain.size[axis]);
    return d.norm() - a.radius - b.radius;
}

double smallest_gap(const core::Domain& domain, const std::vector<core::Sphere>& spheres)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < spheres.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) smallest = std::min(smallest, gap(domain, spheres[a], spheres[b]));
    return smallest;
}

double solid_fraction(const std::vector<core::Sphere>& spheres, double volume)
{
    double solid = 0;
    for (const core::Sphere& s : spheres) solid += 4.0 / 3.0 * std::numbers::pi * std::pow(s.radius, 3);
    return solid / volume;
}

physics::Group group(int count, double radius, const physics::Region& region)
{
    physics::Group g;
    g.like.radius = radius;
    g.like.density = 2000;
    g.count = count;
    g.region = region;
    return g;
}

} // namespace

TEST_CASE("equal spheres fill a periodic box at random to 0.63 without an overlap and without order")
{
    constexpr int count = 1500;
    constexpr double radius = 1e-3;
    const double edge = std::cbrt(count * 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) / 0.63); // random close packing has 0.64
    const core::Domain domain{Vec3::Zero(), Vec3::Constant(edge), {true, true, true}};
    const physics::Region all = physics::BoxRegion{Vec3::Zero(), domain.size};
    const auto spheres = physics::place_densely(domain, {}, {group(count, radius, all)}, 1);
    CHECK(smallest_gap(domain, spheres) >= 0.0);
    // A crystal has a sixth as many neighbours at sqrt 2 diameters as touch; random packings have none of that peak: the density of
    // pairs there is that of any distance around. Shells of 2 % of the diameter, 1.41 beside 1.25 and 1.55 on average.
    std::array<double, 3> pairs{};
    for (std::size_t a = 0; a < spheres.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const double r = gap(domain, spheres[a], spheres[b]) / (2 * radius) + 1;
            constexpr std::array<double, 3> at{1.25, 1.414, 1.55};
            for (std::size_t s = 0; s < 3; ++s)
                if (std::abs(r - at[s]) < 0.02) pairs[s] += 1 / (r * r);
        }
    CHECK(pairs[1] < 1.3 * 0.5 * (pairs[0] + pairs[2])); // a fcc crystal with a spread of 2 % would have ten times as many
}

TEST_CASE("spheres of sizes 1 to 4 fill a pipe between its ends, each in its region")
{
    const core::Domain domain{Vec3::Zero(), Vec3(0.03, 0.02, 0.02), {false, false, false}};
    const std::vector<physics::Wall> walls{physics::CylinderWall{Vec3(0, 0.01, 0.01), Vec3::UnitX(), 0.01},
                                           physics::PlaneWall{Vec3::Zero(), Vec3::UnitX()},
                                           physics::PlaneWall{domain.size, -Vec3::UnitX()}};
    const physics::Region all = physics::BoxRegion{Vec3::Zero(), domain.size};
    const physics::CylinderRegion core_region{Vec3(0.005, 0.01, 0.01), Vec3(0.02, 0.01, 0.01), 0.006};
    const auto spheres = physics::place_densely(domain, {walls}, {group(1000, 0.6e-3, all), group(30, 2.4e-3 / 2, core_region)}, 3);
    CHECK(smallest_gap(domain, spheres) >= 0.0);
    for (const core::Sphere& s : spheres) CHECK(physics::clearance(walls, s.position, s.radius) >= 0.0);
    for (std::size_t n = 1000; n < spheres.size(); ++n) { // to a thousandth of the radius
        const Vec3 x = spheres[n].position;
        CHECK((physics::nearest_point(core_region, x) - x).norm() <= 1e-3 * spheres[n].radius);
    }
}

TEST_CASE("a start with overlaps is relaxed by moves of the size of the overlaps, and one without is left alone")
{
    const core::Domain domain{Vec3::Zero(), Vec3::Constant(0.02), {false, true, false}};
    const std::vector<physics::Wall> walls{physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()}};
    std::vector<core::Sphere> spheres;
    for (int n = 0; n < 512; ++n) spheres.push_back(test::sphere(n, 2.4e-3 * (Vec3(n % 8, n / 8 % 8, n / 64) + Vec3::Constant(0.5)), 1e-3));
    const std::vector<physics::Region> regions(spheres.size(), physics::BoxRegion{Vec3::Zero(), domain.size});
    CHECK(physics::relax_overlaps(domain, walls, regions, spheres).sweeps == 0);
    for (core::Sphere& s : spheres) {
        const auto u = core::random_uniform(1, s.id, 0);
        s.position += 1e-3 * Vec3(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5);
    }
    REQUIRE(smallest_gap(domain, spheres) < -2e-4);
    const physics::Relaxation done = physics::relax_overlaps(domain, walls, regions, spheres);
    CHECK(smallest_gap(domain, spheres) >= 0.0);
    CHECK(done.farthest_move < 1e-3); // each was shaken by less than that
}

TEST_CASE("more than fits is refused")
{
    const core::Domain domain{Vec3::Zero(), Vec3::Constant(0.012), {true, true, true}};
    const physics::Region all = physics::BoxRegion{Vec3::Zero(), domain.size};
    // 0.70: above random close packing, below the densest lattice, which no quench finds.
    CHECK_THROWS_AS((void)physics::place_densely(domain, {}, {group(289, 1e-3, all)}, 1), core::ConfigError);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/particles/insertion.hpp"
#include <doctest/doctest.h>

namespace {

const core::Domain pipe_domain{core::Vec3(0, -0.025, -0.025), core::Vec3(0.09, 0.05, 0.05), {true, false, false}};
const std::vector<physics::Wall> wall{physics::CylinderWall{core::Vec3(0, 0.025, 0.025), core::Vec3::UnitX(), 0.025}};

physics::Group group(int count, double diameter, int species)
{
    physics::Group g;
    g.like.radius = diameter / 2;
    g.like.density = 2000;
    g.like.species = species;
    g.count = count;
    g.region = physics::BoxRegion{core::Vec3::Zero(), pipe_domain.size};
    return g;
}

double overlap(const core::Sphere& a, const core::Sphere& b)
{
    core::Vec3 d = a.position - b.position;
    d.x() -= pipe_domain.size.x() * std::round(d.x() / pipe_domain.size.x());
    return a.radius + b.radius - d.norm();
}

} // namespace

TEST_CASE("spheres of two sizes find places in a pipe without touching each other or the wall")
{
    for (const auto& place : {physics::place_at_random, physics::place_on_lattice}) {
        const auto spheres = place(pipe_domain, {wall}, {group(1067, 2e-3, 0), group(533, 3e-3, 1)}, 1);
        REQUIRE(spheres.size() == 1600);
        for (std::size_t a = 0; a < spheres.size(); ++a) {
            CHECK(spheres[a].id == std::int64_t(a));
            CHECK(spheres[a].species == (a < 1067 ? 0 : 1));
            CHECK(physics::clearance(wall, spheres[a].position, spheres[a].radius) >= -1e-12);
            for (std::size_t b = 0; b < a; ++b) REQUIRE(overlap(spheres[a], spheres[b]) <= 1e-12);
        }
    }
}

TEST_CASE("a region that is too full is refused")
{
    CHECK_THROWS_AS((void)physics::place_at_random(pipe_domain, {wall}, {group(20000, 3e-3, 0)}, 1), core::ConfigError);
    CHECK_THROWS_AS((void)physics::place_on_lattice(pipe_domain, {wall}, {group(20000, 3e-3, 0)}, 1), core::ConfigError);
}

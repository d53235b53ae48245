// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/inflow.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <numbers>

namespace {

using core::Vec3;

const core::Domain domain{Vec3::Zero(), Vec3(0.1, 0.1, 0.1), {true, false, false}};

physics::Inflow stream(physics::Inflow::Measure measure, double rate)
{
    physics::Inflow inflow;
    inflow.like.density = 2500;
    inflow.like.velocity = Vec3(0, -1, 0);
    inflow.sizes = physics::listed_sizes({{1e-3, 1.0}, {2e-3, 1.0}}, physics::ShareOf::number);
    inflow.region = physics::BoxRegion{Vec3(0, 0.08, 0.01), Vec3(0.1, 0.098, 0.09)};
    inflow.measure = measure;
    inflow.rate = rate;
    inflow.begin = 0.5;
    inflow.end = 1.5;
    return inflow;
}

} // namespace

TEST_CASE("as many particles come in as are due, in one piece or in many, at the same places")
{
    const physics::Inflow inflow = stream(physics::Inflow::Measure::number, 100);
    const auto run = [&](int steps) {
        std::vector<core::Sphere> all, near;
        std::int64_t next_id = 7;
        physics::Entered entered;
        for (int step = 1; step <= steps; ++step)
            for (const auto& s : physics::entering(inflow, 2.0 * step / steps, domain, {}, 1, near, next_id, entered)) all.push_back(s);
        CHECK(next_id == 107);
        CHECK(entered.count == 100);
        return all;
    };
    const auto once = run(1), often = run(1000);
    REQUIRE(once.size() == 100); // from 0.5 s to 1.5 s
    REQUIRE(often.size() == 100);
    for (std::size_t n = 0; n < 100; ++n) {
        CHECK(once[n].id == std::int64_t(7 + n));
        CHECK(once[n].position == often[n].position);
        CHECK(once[n].radius == often[n].radius);
        for (std::size_t m = 0; m < n; ++m) {
            Vec3 d = once[n].position - once[m].position;
            d.x() -= 0.1 * std::round(d.x() / 0.1);
            CHECK(d.norm() >= once[n].radius + once[m].radius);
        }
    }
}

TEST_CASE("a stream of mass brings that mass to within a particle, and waits where there is no room")
{
    const physics::Inflow inflow = stream(physics::Inflow::Measure::mass, 1e-3);
    std::vector<core::Sphere> near;
    std::int64_t next_id = 0;
    physics::Entered entered;
    double mass = 0;
    for (const auto& s : physics::entering(inflow, 1.25, domain, {}, 1, near, next_id, entered))
        mass += 4.0 / 3.0 * std::numbers::pi * std::pow(s.radius, 3) * 2500;
    CHECK(mass <= 0.75e-3);
    CHECK(mass > 0.75e-3 - 2500 * std::numbers::pi / 6 * 8e-9); // one of 2 mm
    CHECK(entered.amount == test::relative(mass).epsilon(1e-12));
    // A sphere that fills the region lets nothing in.
    core::Sphere plug;
    plug.position = Vec3(0.05, 0.09, 0.05);
    plug.radius = 0.2;
    std::vector<core::Sphere> plugged{plug};
    CHECK(physics::entering(inflow, 1.5, domain, {}, 1, plugged, next_id, entered).empty());
}

TEST_CASE("particles that may touch a stream are those within reach of its region, through the seam too")
{
    physics::Inflow inflow = stream(physics::Inflow::Measure::number, 1);
    inflow.region = physics::BoxRegion{Vec3(0.098, 0.05, 0.05), Vec3(0.099, 0.06, 0.06)};
    CHECK(physics::may_meet(inflow, domain, Vec3(0.0005, 0.055, 0.055), 1e-3));       // 1.5 mm beyond, reach 2 mm
    CHECK_FALSE(physics::may_meet(inflow, domain, Vec3(0.0015, 0.055, 0.055), 1e-3)); // 2.5 mm
    CHECK_FALSE(physics::may_meet(inflow, domain, Vec3(0.0985, 0.0, 0.055), 1e-3));
}

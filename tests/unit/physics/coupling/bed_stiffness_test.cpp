// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/bed_stiffness.hpp"
#include "physics/coupling/contact_share.hpp"
#include "physics/coupling/mode.hpp"
#include "tests/support/relative.hpp"
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

using core::Vec3;

TEST_CASE("a bed is as stiff as its slowest sway says")
{
    // A row of n masses on springs from a floor, by hand from its characteristic polynomial: n = 1: k; n = 2: k (3 - sqrt 5) / 2 = 0.382 k.
    CHECK(physics::layer_stiffness(6.0, 0.0) ==
          3.0); // along x, of normals (1, 0, r), (-1/2, +-w, r), w^2 = 3/4, r^2 = 2: 6 (1 + 1/4 + 1/4) / 3
    CHECK(physics::bed_stiffness(5.0, 1.0) == 5.0);
    CHECK(std::abs(physics::bed_stiffness(1.0, 2.0) / 0.382 - 1.0) < 0.7); // the continuum: 0.617
    const double n = 50;                                                   // 4 sin^2(pi / (2 (2 n + 1))), the lowest root for any n
    CHECK(physics::bed_stiffness(1.0, n) ==
          test::relative(4.0 * std::pow(std::sin(0.5 * std::acos(-1.0) / (2.0 * n + 1.0)), 2)).epsilon(0.03));
}

TEST_CASE("a bed is as deep as its grains fill the domain along gravity, or towards the nearest boundary")
{
    core::Domain domain;
    domain.size = {1.0, 0.2, 0.1};
    domain.periodic = {true, false, false};
    CHECK(physics::bed_layers(domain, {0, -9.81, 0}, 0.25 * 0.02, 0.01) == test::relative(10.0)); // half of the height at a packing of 0.5
    CHECK(physics::bed_layers(domain, {0, -9.81, 0}, 0.019, 0.01) == test::relative(20.0));       // no deeper than the domain
    CHECK(physics::bed_layers(domain, Vec3::Zero(), 0.25 * 0.02, 0.01) == test::relative(5.0));
    domain.periodic = {true, true, true};
    CHECK(physics::bed_layers(domain, {0, -9.81, 0}, 0.01, 0.01) == 1.0); // nothing holds it: it drifts
}

TEST_CASE("a soft bed with stiff drag and much mass is iterated, and the reason names the ratio and what to change")
{
    physics::StabilityNumbers n{1.0, 3.0, 1.65, 0.6};
    CHECK(physics::choose_mode(n).mode == physics::Mode::pipelined);
    n.softness = 2.0;
    CHECK(physics::choose_mode(n).mode == physics::Mode::iterated);
    CHECK(physics::choose_mode(n).reason.find("K/(k dt)") != std::string::npos);
    CHECK(physics::choose_mode(n).reason.find("contact.stiffness") != std::string::npos);
    CHECK_FALSE(physics::holds(physics::Mode::coarse, n));
    n.softness = 0.1;
    CHECK(physics::choose_mode(n).mode == physics::Mode::pipelined);
    n.stiffness = 2.0; // b M = 6: stiffer springs are needed
    CHECK(physics::choose_mode(n).mode == physics::Mode::iterated);
    CHECK(physics::choose_mode(n).reason.find("K/(k dt) > 0.07") != std::string::npos);
    n.softness = 2.0;
    n.stiffness = 0.1; // b M = 0.3: what it exchanges in a step is little
    CHECK(physics::choose_mode(n).mode == physics::Mode::pipelined);
}

TEST_CASE("the hold of a change is that of springs, of sliding and of what nothing moves")
{
    CHECK(physics::changed_share(1.0, -0.3, 1.0, 4.0) == test::relative(0.3)); // carries all, takes up a third of a change
    CHECK(physics::changed_share(0.6, 0.0, 1.0, 4.0) == 0.0);                  // slides: no more than before
    CHECK(physics::changed_share(0.6, -1e-31, 1e-31, 4.0) == 0.6);             // round-off says nothing
}

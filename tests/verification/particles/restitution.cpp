// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What goes into a contact law as its restitution comes out of an impact.
#include "tests/support/impact.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

/// Restitution in the limit of small steps: the error goes with the step, for damping begins with a jump, or with the fourth root of
/// the overlap; what is left goes with its square, or, for the root, with little less.
double restitution_of_small_steps(test::Impact impact)
{
    double e[3];
    impact.steps = 4000;
    for (double& value : e) {
        value = test::rebound(impact).velocity.z() / -impact.velocity.z();
        impact.steps *= 2;
    }
    const double coarse = 2 * e[1] - e[0], fine = 2 * e[2] - e[1];
    return fine + (fine - coarse) / 3;
}

} // namespace

TEST_CASE("restitution comes out of impacts as it went in, for both laws, between particles and at walls")
{
    const test::Solid alumina{3.8e11, 0.23, 4000.0};
    for (const auto against : {test::Impact::Against::wall, test::Impact::Against::mirror})
        for (const bool hertz : {false, true})
            for (const double e : {0.05, 0.1, 0.3, 0.6, 0.9, 1.0}) {
                test::Impact impact;
                if (hertz) impact.contact = test::hertz(alumina, alumina, e, 0.0);
                else impact.contact = {1e6, 2.0 / 7.0, e, 0.0};
                impact.radius = 2.5e-3;
                impact.density = 4000.0;
                impact.velocity = Vec3(0, 0, -3.9);
                impact.against = against;
                CAPTURE(e);
                CAPTURE(hertz);
                CHECK(std::abs(restitution_of_small_steps(impact) - e) < 1e-6);
            }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Oblique impacts of two equal spheres as Foerster, Louge, Chang and Allia (1994), Measurements of the collision properties of small
// spheres, measured them: restitution e, friction mu, and the reversal beta of a surface that sticks.
#include "tests/support/impact.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

struct Measured {
    double diameter, density, restitution, friction, reversal;
    double restitution_error, friction_error, reversal_error;
};

constexpr Measured glass{3e-3, 2500, 0.97, 0.092, 0.44, 0.01, 0.006, 0.07};
constexpr Measured acetate{6e-3, 1319, 0.87, 0.25, 0.43, 0.02, 0.02, 0.06};

/// Slip of the surfaces over the speed of approach, after the impact, and the restitution.
struct Outcome {
    double slip, restitution;
};

/// @param slip  Slip over the speed of approach before the impact.
Outcome outcome(const Measured& material, double slip)
{
    test::Impact impact;
    impact.radius = material.diameter / 2;
    impact.density = material.density;
    // a spring across the normal of ratio kappa turns by pi sqrt(3.5 kappa) while the other turns by pi: beta is - e cos of it
    const double turn = std::acos(-material.reversal / material.restitution) / std::numbers::pi;
    // so stiff that the normal hardly turns while surfaces slide
    impact.contact = {1e10, turn * turn / 3.5, material.restitution, material.friction};
    const double approach = 0.5; // of each sphere
    impact.velocity = Vec3(slip * approach, 0, -approach);
    impact.against = test::Impact::Against::mirror;
    const test::Rebound out = test::rebound(impact);
    return {(out.velocity.x() - impact.radius * out.spin.y()) / approach, out.velocity.z() / approach};
}

} // namespace

TEST_CASE("spheres that slide lose 7/2 mu (1 + e) of their slip, and spheres that stick turn it round by beta, within what was measured")
{
    for (const Measured& m : {glass, acetate}) {
        const double limit = 3.5 * m.friction * (1 + m.restitution);
        const double scatter = 3.5 * (m.friction_error * (1 + m.restitution) + m.friction * m.restitution_error);
        for (const double share : {0.05, 0.1, 0.2, 1.5, 2.0, 4.0}) { // between them surfaces slide for a part of the contact
            const double slip = share * limit;
            const Outcome after = outcome(m, slip);
            CAPTURE(share);
            CHECK(std::abs(after.restitution - m.restitution) < m.restitution_error);
            if (share > 1) CHECK(std::abs(after.slip - (slip - limit)) < scatter);
            else CHECK(std::abs(after.slip / slip + m.reversal) < m.reversal_error);
        }
    }
}

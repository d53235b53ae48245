// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/particles/contact_laws.hpp"
#include "physics/particles/restitution.hpp"
#include "physics/particles/time_step.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

#include <numbers>

TEST_CASE("damping gives the wanted restitution with a force that never pulls")
{
    // inverted from the closed form of Schwager and Poeschel (2007); six digits are printed
    const double table[][2] = {{0.99, .003206}, {0.95, .016498}, {0.90, .034265}, {0.80, .074355},  {0.60, .180858},
                               {0.50, .255276}, {0.30, .497239}, {0.20, .731247}, {0.10, 1.243188}, {0.05, 1.945346}};
    for (const auto& [restitution, damping] : table) CHECK(std::abs(physics::damping_of(restitution) - damping) < 1e-6);
    CHECK(physics::damping_of(1.0) == 0.0);
    CHECK_THROWS_AS((void)physics::damping_of(0.0), core::ConfigError);
}

TEST_CASE("restitution is continuous through critical damping")
{
    // slope of restitution at zeta = 1 is about -0.1
    CHECK(physics::restitution_of(1.0) == test::relative(std::exp(-2.0)).epsilon(1e-9));
    CHECK(std::abs(physics::restitution_of(1.0 + 1e-9) - physics::restitution_of(1.0 - 1e-9)) < 1e-7);
}

namespace {

/// Head-on impact on a rigid wall by small steps; returns rebound over approach speed.
double impact(double restitution, double steps_per_contact)
{
    const physics::ContactParameters contact{1000.0, 2.0 / 7.0, restitution, 0.5};
    const double mass = 1e-5, step = physics::contact_time(contact, mass) / steps_per_contact;
    const auto law = physics::linear_contact(contact, step);
    double x = 0.0, v = 1.0;
    for (int k = 0; k == 0 || x > 0.0; ++k) {
        x += 0.5 * step * v;
        physics::ContactInput in{};
        in.nx = in.mx = 1.0;
        in.overlap = x;
        in.vx = v;
        in.root_mass = std::sqrt(mass);
        v += step * law(in).fx / mass;
        x += 0.5 * step * v;
    }
    return -v;
}

} // namespace

TEST_CASE("an impact rebounds with the restitution asked for")
{
    for (const double e : {1.0, 0.9, 0.5, 0.2, 0.05}) CHECK(std::abs(impact(e, 20000) - e) < 1e-3); // first order in the step
}

TEST_CASE("a sliding contact keeps the spring of its friction and no dashpot")
{
    const auto law = physics::linear_contact({1000.0, 0.5, 0.8, 0.3}, 1e-6);
    physics::ContactInput in{};
    in.nx = in.mx = 1.0;
    in.overlap = 1e-5;
    in.vy = 2.0;
    in.sy = 1e-4;
    in.root_mass = 1e-3;
    const auto out = law(in);
    CHECK(out.fx == test::relative(-0.01).epsilon(1e-14));
    CHECK(out.fy == test::relative(-0.003).epsilon(1e-14));
    CHECK(out.sy == test::relative(0.003 / 500.0).epsilon(1e-14));
    CHECK(out.sx == 0.0);
}

TEST_CASE("the tangential spring turns with the contact and keeps its length")
{
    const auto law = physics::linear_contact({1000.0, 0.5, 1.0, 1e9}, 0.0);
    physics::ContactInput in{};
    const double angle = 0.01;
    in.nx = in.mx = std::cos(angle);
    in.ny = in.my = std::sin(angle);
    in.overlap = 1e-5;
    in.sy = 1e-6;
    in.sz = 2e-6;
    const auto out = law(in);
    CHECK(std::sqrt(out.sx * out.sx + out.sy * out.sy + out.sz * out.sz) == test::relative(std::sqrt(5.0) * 1e-6).epsilon(1e-14));
    CHECK(std::abs(out.sx * in.nx + out.sy * in.ny) < 1e-21);
}

TEST_CASE("steps above the stable limit are refused")
{
    core::ParticleSet particles;
    core::Sphere s;
    s.radius = 1e-3;
    s.density = 2000.0;
    particles.add(s);
    const auto limits = physics::step_limits(particles, {});
    CHECK(physics::choose_step(limits, 0.0) < 0.1 * limits.contact_time);
    CHECK_THROWS_AS((void)physics::choose_step(limits, 1.01 * limits.stable), core::ConfigError);
    CHECK_THROWS_AS((void)physics::choose_step(limits, -1e-6), core::ConfigError);
}

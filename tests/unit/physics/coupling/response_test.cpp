// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/contact_share.hpp"
#include "physics/coupling/mode.hpp"
#include "physics/coupling/response.hpp"
#include "tests/support/relative.hpp"

#include <Eigen/LU>
#include <doctest/doctest.h>

using physics::Mode;

TEST_CASE("the response of a cell equals the solution of its coupled equations")
{
    // Fluid and two unlike free grains: (F + k1 + k2) du - k1 dv1 - k2 dv2 = dt phi, (m + k) dv - k du = dt V.
    const physics::GrainCoupling one{1.2, 0.2, 0.7, 0.1}, two{0.5, 0.1, 9.0, 0.05};
    const double phi = 0.7, fluid = 0.7, dt = 0.01, k1 = 0.8, k2 = 9.05;
    Eigen::Matrix3d matrix;
    matrix << fluid + k1 + k2, -k1, -k2, -k1, 1.2 + k1, 0.0, -k2, 0.0, 0.5 + k2;
    const Eigen::Vector3d exact = matrix.inverse() * Eigen::Vector3d(dt * phi, dt * 0.2, dt * 0.1);
    const auto a = physics::response_to_pressure(one, 1.0), b = physics::response_to_pressure(two, 1.0);
    const physics::GrainResponse sum{a.reaction + b.reaction, a.flux + b.flux, a.displaced + b.displaced, 0.0, 0.0};
    const auto found = physics::cell_response(fluid, phi, sum, dt);
    CHECK(found.velocity == test::relative(exact[0]).epsilon(1e-12));
    CHECK(found.mobility == test::relative(phi * exact[0] + 0.2 * exact[1] + 0.1 * exact[2]).epsilon(1e-12));
}

TEST_CASE("a grain follows a change of fluid velocity as its equation of motion says")
{
    const double mass = 1.2, volume = 0.2, drag = 0.7, added = 0.1, dt = 1.0, yield = 0.6;
    double v = 0, impulse = 0; // (m + q a) dv/dt = q (K (1 - v) + a / dt): fluid that is faster by 1, reached evenly over the step
    constexpr int parts = 200000;
    for (int n = 0; n < parts; ++n) {
        const double middle = v + 0.5 * dt / parts * yield * (drag * (1 - v) + added) / (mass + yield * added);
        const double gain = dt / parts * yield * (drag * (1 - middle) + added) / (mass + yield * added);
        impulse += dt / parts * drag * (1 - middle) + added / parts - added * gain;
        v += gain;
    }
    const auto found = physics::response_to_velocity({mass, volume, drag * dt, added}, yield);
    CHECK(found.flux == test::relative(volume * v).epsilon(1e-8));
    CHECK(found.reaction == test::relative(impulse).epsilon(1e-8));
    CHECK(found.added_flux / found.flux == test::relative(added / (drag * dt + added)));
}

TEST_CASE("a fluid whose velocity grows evenly over the step moves a free grain as the equation of motion says, and what is owed arrives")
{
    const double mass = 1.2, volume = 0.2, drag = 0.7, added = 0.1;
    double v = 0; // (m + a) dv/dt = K (t - v) + a, t from 0 to 1
    constexpr int parts = 200000;
    for (int n = 0; n < parts; ++n) {
        const double at = (n + 0.5) / parts, rate = (drag * (at - v) + added) / (mass + added);
        v += (drag * (at - v - 0.5 * rate / parts) + added) / (mass + added) / parts;
    }
    const physics::GrainCoupling grain{mass, volume, drag, added, physics::growth_share(drag / (mass + added))};
    CHECK(physics::response_to_velocity(grain, 1.0).flux == test::relative(volume * v).epsilon(1e-8));
    CHECK(physics::response_to_velocity(grain, 0.0).reaction == drag + added); // held: the whole change
    for (const double x : {1e-9, 9.99e-3, 1.001e-2, 0.3, 4.0, 50.0}) {
        const double exact = x < 0.02 ? 0.5 + x / 12 - x * x * x / 720 : 1 / (1 - std::exp(-x)) - 1 / x;
        CHECK(physics::growth_share(x) == test::relative(exact).epsilon(1e-11));
    }
    CHECK(physics::growth_share(1e6) == test::relative(1 - 1e-6).epsilon(1e-12));
    CHECK((mass + added) * 1.0 == test::relative(mass * physics::delivery_factor(grain, 1.0)).epsilon(1e-14)); // force of a gain of 1
    CHECK(physics::delivery_factor(grain, 0.0) == 1.0);
}

TEST_CASE("a held grain takes the full drag and gives no way; a share outside 0..1 is clipped")
{
    for (const auto response : {physics::response_to_pressure, physics::response_to_velocity}) {
        const auto held = response({1.0, 0.3, 5.0, 0.0}, 0.0);
        CHECK(held.reaction == 5.0);
        CHECK(held.flux == 0.0);
        CHECK(held.displaced == 0.0);
    }
    CHECK(physics::contact_share(-2.0, 2.0) == 1.0);
    CHECK(physics::contact_share(-9.0, 2.0) == 1.0);
    CHECK(physics::contact_share(1.0, 2.0) == 0.0);
    CHECK(physics::contact_share(0.0, 0.0) == 0.0);
}

TEST_CASE("auto takes the mode that holds and says why")
{
    CHECK(physics::choose_mode({0.1, 3.0, 1.65, 0.6}).mode == Mode::pipelined);              // sand in water
    CHECK(physics::choose_mode({0.1, 1200.0, 0.004, 0.05, 100.0}).mode == Mode::concurrent); // few grains of glass in air
    CHECK(physics::choose_mode({30.0, 3.0, 1.3, 0.6}).mode == Mode::iterated);               // 50 um in water
    CHECK(physics::choose_mode({30.0, 3.0, 1.3, 0.6}).reason.find("b = 30") != std::string::npos);
    CHECK(!physics::holds(Mode::concurrent, {0.1, 3.0, 1.65, 0.6}));
    CHECK(physics::holds(Mode::iterated, {1e5, 2000.0, 3.0, 0.6}));
    // NUMERICS B5: the seed, s = 2, phi = 0.4, C_m = 1/2.
    CHECK(physics::added_mass_amplification(0.4, 2.0, 0.5) == test::relative(1.65).epsilon(1e-12));
}

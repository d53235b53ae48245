// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/turbulence.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <initializer_list>

using physics::Turbulence;

namespace {

/// One step of a place where nothing is carried and nothing diffuses.
Turbulence advanced(const Turbulence& at, double strain, double dt)
{
    constexpr double syrup = 1.0; // [m2/s]: the bound of the eddy viscosity, 1e5 of that, is far
    const double produced = physics::production(physics::eddy_viscosity(at.k, at.epsilon, syrup), strain, at.epsilon);
    const auto s = physics::turbulence_sources(at, produced, dt);
    return {s.k.source / s.k.capacity, s.epsilon.source / s.epsilon.capacity};
}

} // namespace

TEST_CASE("turbulence without production decays by its power law, in one step or many")
{
    // NUMERICS U7: turnovers, k / k0, epsilon / epsilon0.
    struct Row {
        double time, k, epsilon;
    };
    for (const Row& row : {Row{0.1, 0.90876931, 0.83220633}, Row{1, 0.49211192, 0.25630829}, Row{10, 0.08011161, 0.00785408}}) {
        const Turbulence start{0.02, 0.3};
        const Turbulence once = advanced(start, 0, row.time * start.k / start.epsilon);
        CHECK(once.k / start.k == test::relative(row.k).epsilon(1e-7)); // eight digits are printed
        CHECK(once.epsilon / start.epsilon == test::relative(row.epsilon).epsilon(1e-6));
        Turbulence often = start;
        for (int n = 0; n < 100; ++n) often = advanced(often, 0, 0.01 * row.time * start.k / start.epsilon);
        CHECK(often.k == test::relative(once.k).epsilon(1e-13)); // round-off of 100 steps
        CHECK(often.epsilon == test::relative(once.epsilon).epsilon(1e-13));
    }
}

TEST_CASE("in a homogeneous shear production over dissipation tends to 2.0909")
{
    // NUMERICS U8: (C_2 - 1) / (C_1 - 1). Steps of 1e-4 turnovers leave an error of that order.
    const double shear = 100;
    Turbulence t{1e-3, 1e-2};
    for (int n = 0; n < 150000; ++n) t = advanced(t, shear * shear, 1e-4 * t.k / t.epsilon);
    const double ratio = physics::k_epsilon.c_mu * t.k * t.k / t.epsilon * shear * shear / t.epsilon;
    CHECK(ratio == test::relative(0.92 / 0.44).epsilon(1e-3));
}

TEST_CASE("k and epsilon stay positive and finite for any step, strain and start")
{
    for (const double dt : {1e-12, 1e-3, 1.0, 1e6, 1e12})
        for (const double k : {physics::least_turbulence.k, 1e-6, 1.0, 1e4})
            for (const double epsilon : {physics::least_turbulence.epsilon, 1e-6, 1.0, 1e6})
                for (const double strain : {0.0, 1.0, 1e8}) {
                    const Turbulence t = advanced({k, epsilon}, strain, dt);
                    const bool sound = t.k > 0 && t.epsilon > 0 && std::isfinite(t.k) && std::isfinite(t.epsilon);
                    CHECK_MESSAGE(sound, dt, " ", k, " ", epsilon, " ", strain);
                }
}

TEST_CASE("strain a hundred times faster than turbulence does not make it without bounds")
{
    // NUMERICS D 36: S k / epsilon = 100 would produce 900 times what dissipates.
    const double k = 0.1, epsilon = 1.0, strain = std::pow(100 * epsilon / k, 2);
    CHECK(physics::production(physics::eddy_viscosity(k, epsilon, 1e-6), strain, epsilon) <= 10 * epsilon);
}

TEST_CASE("friction at walls follows the viscous law below y* = 11.2, the logarithmic one above, and does not jump")
{
    const double nu = 1e-6, y = 1e-3;
    const auto at = [&](double distance) {
        return physics::wall_layer(std::pow(distance * nu / y, 2) / std::sqrt(physics::k_epsilon.c_mu), y, nu, 0);
    };
    for (const double distance : {0.0, 0.5, 1.0, 5.0, 11.0}) CHECK(at(distance).viscosity == 1.0);
    for (const double distance : {30.0, 300.0, 1e4})
        CHECK(at(distance).viscosity == test::relative(0.4187 * distance / std::log(9.793 * distance)).epsilon(1e-12));
    for (double distance = 0; distance < 200; distance += 0.01) {
        const auto low = at(distance), high = at(distance + 0.01);
        CHECK(std::abs(high.viscosity - low.viscosity) < 2e-3); // the slope is at most kappa / ln(E y*) = 0.09
        CHECK(std::abs(high.turbulent - low.turbulent) < 2e-3);
        const double rise = physics::wall_dissipation(high, 1.0, y, nu) / physics::wall_dissipation(low, 1.0, y, nu);
        if (distance > 1) CHECK(std::abs(rise - 1) < 0.04); // epsilon changes by y*^3 at most
    }
    // Far from the wall what is produced there dissipates there: the friction is C_mu^(1/2) k.
    const auto far = at(200.0);
    const double slip = far.friction_speed * std::log(9.793 * 200.0) / 0.4187, k = std::pow(far.friction_speed, 2) / 0.3;
    CHECK(physics::wall_production(far, slip, y, nu) == test::relative(physics::wall_dissipation(far, k, y, nu)).epsilon(0.01));
}

TEST_CASE("rough walls brake more, and grains as large as cells are no singularity")
{
    const double nu = 1e-6, y = 1e-2, k = 0.01;
    double before = physics::wall_layer(k, y, nu, 0).viscosity;
    for (const double roughness : {1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
        const auto layer = physics::wall_layer(k, y, nu, roughness);
        CHECK(layer.viscosity > before * (1 - 1e-12));
        CHECK(layer.viscosity <= layer.distance);
        before = layer.viscosity;
    }
}

TEST_CASE("fully rough walls follow Nikuradse's law to 2 % at any distance")
{
    const double nu = 1e-6, speed = 0.1, k = speed * speed / std::sqrt(physics::k_epsilon.c_mu);
    for (const double grains : {70.0, 200.0, 1000.0, 1e5}) // k_s+: the wall is fully rough from 70 on
        for (const double share : {1.0, 3.0, 10.0, 100.0, 1e4}) {
            const double roughness = grains * nu / speed, y = share * roughness;
            const auto layer = physics::wall_layer(k, y, nu, roughness);
            CHECK(layer.distance / layer.viscosity == test::relative(std::log(share) / 0.4187 + 8.5).epsilon(0.02));
        }
}

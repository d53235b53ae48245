// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/own_disturbance.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

namespace {

constexpr double pi = std::numbers::pi;

/// Velocity at the centre of a Gaussian force in Oseen's flow over that in Stokes' flow, by sums over wave numbers, s = mu = 1.
double oseen_by_sums(double density_times_speed, double resistance)
{
    constexpr int parts = 2000;
    double found = 0, stokes = 0;
    for (int i = 0; i < parts; ++i) {
        const double x = (i + 0.5) / parts;
        for (int j = 0; j < parts; ++j) {
            const double k = 8.0 * (j + 0.5) / parts, weight = (1 - x * x) * std::exp(-0.5 * k * k);
            const double kk = k * k + resistance;
            found += weight * k * k * kk / (kk * kk + density_times_speed * density_times_speed * k * k * x * x);
            stokes += weight;
        }
    }
    return found / stokes;
}

} // namespace

TEST_CASE("the share of Oseen's wake is its integral over wave numbers")
{
    for (const double speed : {0.1, 1.0, 10.0}) {
        CHECK(physics::oseen_share(speed / std::sqrt(2.0)) == test::relative(oseen_by_sums(speed, 0)).epsilon(2e-3)); // the sums
    }
    CHECK(physics::oseen_share(0) == 1.0);
    for (const double edge : {0.02, 1e4}) // branches meet: what each leaves out
        CHECK(physics::oseen_share(edge * 0.9999999) == test::relative(physics::oseen_share(edge * 1.0000001)).epsilon(2e-4));
}

TEST_CASE("what resists the wake is what Brinkman's medium leaves of it")
{
    CHECK(physics::screened_share(0) == 1.0);
    for (const double alpha : {0.3, 1.0, 4.0}) // alpha s
        CHECK(physics::screened_share(alpha / std::sqrt(2.0)) == test::relative(oseen_by_sums(0, alpha * alpha)).epsilon(2e-3));
    CHECK(physics::screened_share(5.999999) == test::relative(physics::screened_share(6.000001)).epsilon(1e-4)); // 105 / (2 z^2)^4
}

TEST_CASE("a Stokes grain samples 0.40 d / s of its slip, built up in s^2 / nu")
{
    const double d = 1e-4, mu = 1e-3, s = 3e-4;
    const physics::Wake wake = physics::wake_of({3 * pi * mu * d, 0.0, s * s, 0.0, 1000.0, mu});
    CHECK(wake.share == test::relative(d / (std::sqrt(2 * pi) * s)).epsilon(1e-12));
    CHECK(wake.time == test::relative(1000.0 * s * s / mu).epsilon(1e-12));
    CHECK(physics::wake_of({}).share == 0.0); // no drag yet
}

TEST_CASE("in a packing a grain finds itself neither in the fraction nor in the velocity")
{
    const double d = 1e-3, volume = pi / 6 * d * d * d, width = 2 * d;
    const double own = physics::own_fraction(volume, width, {0.01 * d * d, 0.0});
    CHECK(own == test::relative(volume * std::pow(pi * width * width, -1.5)).epsilon(1e-3)); // thin cells: exp(-r^2 / b^2)
    const double h = 10 * d; // in the middle of a cell without a filter, and in its corner: an eighth in each of eight, an eighth sampled
    CHECK(physics::own_fraction(volume, 0.0, {h * h, 0.0}) == test::relative(volume / (h * h * h)).epsilon(1e-12));
    CHECK(physics::own_fraction(volume, 0.0, {h * h, 0.25 * h * h}) == test::relative(0.125 * volume / (h * h * h)).epsilon(1e-12));
    CHECK(physics::fraction_of_others(0.6, own) == test::relative(0.6).epsilon(1e-3));
    CHECK(physics::fraction_of_others(own, own) == 0.0); // alone
    CHECK(physics::crowding_fraction(own, own) == 0.0);
    // Few others, n of them: what they add is less by the 8 own that each keeps free around itself.
    CHECK(physics::fraction_of_others(own + 1e-4 * (1 - 8 * own), own) == test::relative(1e-4).epsilon(1e-3));
    const double dense_drag = 150 * 0.6 / 0.4 * 1e-3 * volume / (d * d);
    CHECK(physics::wake_of({dense_drag, 0.0, 4 * d * d, 0.6 / volume, 1000.0, 1e-3}).share < 0.02);
}

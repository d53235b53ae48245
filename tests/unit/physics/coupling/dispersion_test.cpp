// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.hpp"
#include "physics/coupling/dispersion.hpp"
#include "physics/coupling/turbulence_damping.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <vector>

namespace {

/// What a step makes of the fluctuation before it, of the drift and of each draw: it is linear in all of them.
struct Shares {
    physics::Fluctuation before, drift, first, second;
};

Shares shares(double rate, double dt)
{
    using physics::fluctuate;
    return {fluctuate(1, 0, rate, dt, {0, 0}), fluctuate(0, 1, rate, dt, {0, 0}), fluctuate(0, 0, rate, dt, {1, 0}),
            fluctuate(0, 0, rate, dt, {0, 1})};
}

/// Variances and covariance of the end and the mean.
struct Spread {
    double end, both, mean;
};

Spread spread(const Shares& s)
{
    return {s.first.at_end * s.first.at_end + s.second.at_end * s.second.at_end,
            s.first.at_end * s.first.mean + s.second.at_end * s.second.mean, s.first.mean * s.first.mean + s.second.mean * s.second.mean};
}

} // namespace

TEST_CASE("a fluctuation over one step is drawn from what two steps of half the length draw it from")
{
    for (const double x : {1e-6, 0.009, 0.011, 0.3, 2.0, 40.0, 600.0}) {
        CAPTURE(x);
        const Shares one = shares(2.0, x / 2.0), half = shares(2.0, x / 4.0);
        CHECK(one.before.at_end == test::relative(half.before.at_end * half.before.at_end).epsilon(1e-12));
        CHECK(one.before.mean == test::relative(0.5 * half.before.mean * (1 + half.before.at_end)).epsilon(1e-12));
        const Spread of_one = spread(one), of_half = spread(half);
        const double kept = half.before.at_end, passed_on = half.before.mean;
        CHECK(of_one.end == test::relative(of_half.end * (1 + kept * kept)).epsilon(1e-12));
        // Ends and means of both halves; the mean of the second follows the end of the first.
        const double both = 0.5 * (kept * of_half.both + kept * passed_on * of_half.end + of_half.both);
        const double mean = 0.25 * (2 * of_half.mean + 2 * passed_on * of_half.both + passed_on * passed_on * of_half.end);
        CHECK(of_one.both == test::relative(both).epsilon(1e-9));
        CHECK(of_one.mean == test::relative(mean).epsilon(1e-9)); // 1e-10 are lost where tanh cancels, x = 0.01
    }
}

TEST_CASE("a fluctuation keeps variance 1, and over long steps spreads as far as its time of memory says")
{
    for (const double dt : {1e-3, 0.5, 100.0}) {
        const Shares s = shares(3.0, dt);
        CHECK(s.before.at_end * s.before.at_end + spread(s).end == test::relative(1).epsilon(1e-14));
    }
    const double rate = 3.0, dt = 1e4;
    CHECK(spread(shares(rate, dt)).mean * dt * dt == test::relative(2 * dt / rate).epsilon(1e-4)); // 2 T dt, less 3 T^2
}

TEST_CASE("the drift pushes as a force does in short steps, and in long ones as far as a gradient of diffusivity")
{
    const physics::Fluctuation brief = shares(2.0, 1e-5).drift, lasting = shares(2.0, 1e5).drift;
    CHECK(brief.at_end == test::relative(1e-5).epsilon(1e-4));
    CHECK(brief.mean == test::relative(1e-5).epsilon(1e-4)); // half of it by the push, half by what a constant deviation leaves out
    CHECK(lasting.at_end == test::relative(0.5).epsilon(1e-12));
    CHECK(lasting.mean == test::relative(2 * 0.5).epsilon(1e-4)); // s times it is d(s^2 T)/dx
}

TEST_CASE("what is well mixed between walls stays so, for steps that are short beside the time of memory and for steps as long")
{
    // Deviation and time grow with the distance from walls at 0 and 1, as beside walls that nothing passes.
    constexpr double pi = std::numbers::pi;
    constexpr int count = 20000, layers = 10;
    for (const double dt : {0.02, 0.1}) {
        CAPTURE(dt);
        std::vector<double> place(count), before(count);
        for (int n = 0; n < count; ++n) {
            place[std::size_t(n)] = (n + 0.5) / count;
            before[std::size_t(n)] = core::random_normal(1, n, 0)[0];
        }
        const auto steps = std::uint64_t(4.0 / dt);
        for (std::uint64_t step = 1; step <= steps; ++step)
            for (int n = 0; n < count; ++n) {
                double &x = place[std::size_t(n)], &g = before[std::size_t(n)];
                const double deviation = 0.5 * std::sin(pi * x), growth = 0.5 * pi * std::cos(pi * x), time = 0.1;
                const auto draw = core::random_normal(1, n, step);
                const auto [end, mean] = physics::fluctuate(g, growth, 1 / time, dt, {draw[0], draw[1]});
                x = std::abs(x + deviation * mean * dt);
                if (x > 1) x = 2 - x;
                g = end;
            }
        std::array<int, layers> found{};
        for (const double x : place) ++found[std::size_t(std::min(x, 1 - 1e-12) * layers)];
        // Counting 2000 of 20,000 has a standard deviation of 42: four of it, and 1 % for steps as long as the memory.
        for (const int n : found) CHECK(std::abs(n - count / layers) < 4 * 42 + 20);
    }
}

TEST_CASE("turbulence at a grain has the numbers of its model, and grains that fall through it forget sooner")
{
    CHECK(physics::fluctuation_deviation(0.015) == test::relative(0.1).epsilon(1e-12));
    CHECK(physics::fluctuation_rate(0.01, 0.006) == test::relative(2.0).epsilon(1e-12));
    CHECK(physics::crossing_rate({0.1, core::Vec3::Zero(), 2.0}, 0.0) == 2.0);
    CHECK(physics::crossing_rate({0.3, core::Vec3::Zero(), 2.0}, 0.4) == test::relative(10.0 / 3).epsilon(1e-12));
}

TEST_CASE("grains damp turbulence as their drag takes up what they do not follow")
{
    const physics::Turbulence at{0.01, 0.5};
    CHECK(physics::turbulence_damping({}, 400, at) == 0.0);
    // Grains that do not follow at all: 2 K / (rho phi). A bed of sand of 0.5 mm has 5e5 kg/(m3 s): 2 ms.
    CHECK(physics::turbulence_damping({5e5, 1e9}, 400, at) == test::relative(2500).epsilon(1e-12));
    // A Stokes number of 4: 1 - exp(-1). 6 epsilon / k = 300 1/s, so 4 / 300 s.
    CHECK(physics::turbulence_damping({3e4, 400}, 400, at) == test::relative(150 * (1 - std::exp(-1.0))).epsilon(1e-12));
    // Grains that follow are more fluid to stir, 12 / 4 of their share of the mass times epsilon / k.
    CHECK(physics::turbulence_damping({1e12, 400}, 400, at) == test::relative(3 * 50).epsilon(1e-6));
    const physics::Turbulence left = physics::damped(at, 2.0, 0.5);
    CHECK(left.k == test::relative(0.01 * std::exp(-1.0)).epsilon(1e-12));
    CHECK(left.epsilon == test::relative(0.5 * std::exp(-1.2)).epsilon(1e-12));
    CHECK(physics::damped(at, 1e9, 1.0).k == physics::least_turbulence.k);
}

TEST_CASE("normal numbers have the moments of a normal distribution, and those of different counters are not related")
{
    constexpr int count = 40000;
    double mean = 0, variance = 0, fourth = 0, related = 0;
    for (int n = 0; n < count; ++n) {
        const auto draw = core::random_normal(7, n, 3), next = core::random_normal(7, n, 4);
        for (std::size_t a = 0; a < 4; ++a) {
            mean += draw[a];
            variance += draw[a] * draw[a];
            fourth += std::pow(draw[a], 4);
            related += draw[a] * next[a];
        }
    }
    const double samples = 4.0 * count, noise = 4 / std::sqrt(samples); // four standard deviations of a mean of such numbers
    CHECK(std::abs(mean / samples) < noise);
    CHECK(std::abs(variance / samples - 1) < noise * std::sqrt(2.0));
    CHECK(std::abs(fourth / samples - 3) < noise * std::sqrt(96.0));
    CHECK(std::abs(related / samples) < noise);
}

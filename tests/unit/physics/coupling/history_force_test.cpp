// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/history_force.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <functional>

namespace {

/// int from 0 to t of g(s) / sqrt(t - s) ds, by Simpson's rule in sqrt(t - s).
double half_integral(const std::function<double(double)>& g, double t)
{
    constexpr int parts = 400;
    const double root = std::sqrt(t);
    double sum = 0;
    for (int n = 0; n <= parts; ++n) {
        const double x = root * n / parts, weight = n == 0 || n == parts ? 1 : n % 2 ? 4 : 2;
        sum += weight * 2 * g(t - x * x);
    }
    return sum * root / (3 * parts);
}

/// Largest error of the mean over a step of the half integral of cos, over the largest value, with `steps` steps to t = 5.
double error_of(int steps)
{
    const auto g = [](double t) { return std::cos(t); };
    const double dt = 5.0 / steps;
    const physics::HistoryTail tail(1.0);
    physics::HistoryMemory memory;
    double worst = 0, last = 0;
    for (int n = 0; n < steps; ++n) {
        const double t = n * dt, mean = (std::sin(t + dt) - std::sin(t)) / dt;
        const double found = physics::history_mass(1.0, dt) * mean + physics::history_of(memory, tail, dt, last);
        constexpr int parts = 20;
        double exact = 0;
        for (int m = 0; m < parts; ++m) exact += half_integral(g, t + (m + 0.5) * dt / parts) / parts;
        if (n > 0) worst = std::max(worst, std::abs(found - exact));
        memory = physics::remembered(memory, tail, mean, dt, last);
        last = dt;
    }
    return worst / std::sqrt(std::acos(-1.0));
}

} // namespace

TEST_CASE("the tail of the history kernel is 1 / sqrt t to 0.4 % where it is said to be")
{
    const physics::HistoryTail tail(2.0);
    for (double t = 2e-4; t < 4.0; t *= 1.7) {
        double sum = 0;
        for (std::size_t k = 0; k < physics::HistoryTail::modes; ++k) sum += tail.weight[k] * std::exp(-tail.rate[k] * t);
        // Beyond the step's 0.35 %, t / (1000 d^2 / nu) of long times is left out: 0.757 sqrt(rate_0 t).
        CHECK(std::abs(sum * std::sqrt(t) - 1.0) < 0.004 + 0.76 * std::sqrt(tail.rate[0] * t));
    }
}

TEST_CASE("where the slip carries vorticity away memory fades with the integral of Mei and Adrian's kernel")
{
    // Their kernel over Basset's, as printed: a the radius, U the slip; d = 1, nu = 1. In x with t = x^4 both are smooth at 0.
    for (const double reynolds : {0.3, 1.5, 30.0, 500.0}) {
        const double fH = 0.75 + 0.105 * reynolds, a = 0.5, pi = std::acos(-1.0);
        const double rate = physics::history_fading(reynolds, 1.0), end = 60.0 / std::pow(rate, 0.25);
        double theirs = 0, ours = 0;
        constexpr int parts = 400000;
        for (int n = 0; n < parts; ++n) {
            const double x = end * (n + 0.5) / parts, t = x * x * x * x, dt = 4 * x * x * x * end / parts;
            const double creeping = std::pow(pi * t / (a * a), 0.25);
            const double carried = std::sqrt(0.5 * pi * std::pow(reynolds, 3) / (a * std::pow(fH, 3)) * t * t);
            theirs += dt / std::pow(creeping + carried, 2);
            ours += dt * std::exp(-rate * t) * a / std::sqrt(pi * t);
        }
        CAPTURE(reynolds);
        CHECK(ours == test::relative(theirs).epsilon(1e-4)); // what is left beyond the end goes as 1 / t
    }
    CHECK(physics::history_fading(0.0, 1.0) == 0.0);
}

TEST_CASE("the history of constant acceleration grows as 2 sqrt t, whatever the steps")
{
    const physics::HistoryTail tail(1.0);
    physics::HistoryMemory memory;
    double t = 0, last = 0;
    for (int n = 0; n < 200; ++n) {
        const double dt = n % 3 == 0 ? 0.002 : n % 3 == 1 ? 0.0005 : 0.001;
        const double found = physics::history_mass(1.0, dt) + physics::history_of(memory, tail, dt, last);
        const double exact = 4.0 / 3.0 * (std::pow(t + dt, 1.5) - std::pow(t, 1.5)) / dt; // mean of 2 sqrt t
        CHECK(found == test::relative(exact).epsilon(0.01)); // the tail's 0.4 % and what it leaves out of long times
        memory = physics::remembered(memory, tail, 1.0, dt, last);
        t += dt;
        last = dt;
    }
}

TEST_CASE("the history of a swinging acceleration is that of its integral, to the tail")
{
    // The tail is 0.4 % off, and lacks 0.76 sqrt(nu / 1000 d^2) at all times, whose integral over g is at most that: 1.4 %.
    CHECK(error_of(20) < 0.022); // and the coarse steps
    CHECK(error_of(160) < 0.018);
}

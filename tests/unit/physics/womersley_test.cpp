// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/womersley.hpp"
#include "tests/support/relative.hpp"
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace {

struct Published {
    double amplitude, lead; // [P / omega], [degrees] before the forcing
};

struct Row {
    double alpha;
    Published mean;
    std::array<Published, 5> at; // r = 0, 0.25, 0.5, 0.75, 0.9 of the radius
};

// NUMERICS C1.5, computed with scaled Bessel functions of another library.
constexpr std::array<double, 5> radii{0.0, 0.25, 0.5, 0.75, 0.9};
const std::array<Row, 5> table{
    Row{1, {0.123196, -9.453}, {{{0.246232, -10.645}, {0.230874, -10.422}, {0.184776, -9.751}, {0.107865, -8.634}, {0.046873, -7.749}}}},
    Row{3,
        {0.616899, -54.303},
        {{{1.174457, -64.292}, {1.112730, -62.424}, {0.918656, -56.899}, {0.564350, -47.933}, {0.255155, -41.018}}}},
    Row{5,
        {0.755610, -71.353},
        {{{1.160460, -89.852}, {1.155026, -86.760}, {1.085566, -77.497}, {0.791865, -62.069}, {0.399395, -49.820}}}},
    Row{10,
        {0.868351, -81.307},
        {{{0.993820, -89.855}, {0.993901, -90.462}, {1.038360, -90.903}, {1.057264, -79.442}, {0.693111, -60.774}}}},
    Row{20,
        {0.931764, -85.803},
        {{{0.999997, -90.000}, {1.000018, -90.003}, {0.999154, -89.951}, {1.031181, -90.722}, {0.992995, -75.223}}}}};

physics::WomersleyFlow flow(double alpha) { return physics::WomersleyFlow({2.0, 4.0 / (alpha * alpha), 1.0, 1.0}); }

void check(std::complex<double> amplitude, const Published& expected)
{
    CHECK(std::abs(amplitude) == test::relative(expected.amplitude).epsilon(1e-5)); // six decimals are printed
    CHECK(std::arg(amplitude) * 180 / std::numbers::pi == test::relative(expected.lead).epsilon(1e-4));
}

} // namespace

TEST_CASE("amplitudes and phases are the published ones at five Womersley numbers")
{
    for (const Row& row : table) {
        CAPTURE(row.alpha);
        const auto solution = flow(row.alpha);
        CHECK(solution.alpha() == test::relative(row.alpha));
        check(solution.mean_amplitude(), row.mean);
        for (std::size_t n = 0; n < radii.size(); ++n) check(solution.amplitude(2.0 * radii[n]), row.at[n]);
    }
    check(flow(147.7).mean_amplitude(), {0.990471, -89.446}); // where unscaled functions overflow
}

TEST_CASE("the two series of the Bessel functions meet where one takes over from the other")
{
    const auto direction = std::polar(1.0, 0.25 * std::numbers::pi);
    for (const auto& function : {physics::scaled_bessel_0, physics::scaled_bessel_1}) {
        // Over 2e-9 around the seam the functions themselves change by 1e-10 relative.
        const auto below = function((20.0 - 1e-9) * direction), above = function((20.0 + 1e-9) * direction);
        CHECK(std::abs(below - above) < 1e-9 * std::abs(above));
    }
}

TEST_CASE("the profile satisfies the equation of motion")
{
    const double alpha = 7, h = 1e-3, time = 0.3;
    const auto solution = flow(alpha);
    const double nu = 4.0 / (alpha * alpha);
    for (const double r : {0.3, 1.1, 1.8}) {
        const auto u = [&](double radius) { return solution.velocity(radius, time); };
        const double laplacian = (u(r + h) - 2 * u(r) + u(r - h)) / (h * h) + (u(r + h) - u(r - h)) / (2 * h * r);
        const double rate = (solution.velocity(r, time + h) - solution.velocity(r, time - h)) / (2 * h);
        CHECK(rate == test::relative(std::cos(time) + nu * laplacian).epsilon(1e-4)); // differences of h^2 = 1e-6 times curvatures near 50
    }
}

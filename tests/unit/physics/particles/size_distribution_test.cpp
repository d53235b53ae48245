// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/particles/size_distribution.hpp"
#include "tests/support/relative.hpp"
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace {

using physics::ShareOf;

/// Share of the mass of diameters up to `diameter`.
double mass_passing(const std::vector<double>& diameters, double diameter)
{
    double all = 0, passing = 0;
    for (const double d : diameters) {
        all += d * d * d;
        passing += d <= diameter ? d * d * d : 0.0;
    }
    return passing / all;
}

} // namespace

TEST_CASE("listed sizes are met to the particle by number, and by mass as closely as whole particles can")
{
    const auto by_number = physics::diameters_of(physics::listed_sizes({{1e-3, 1.0}, {2e-3, 2.0}, {5e-3, 1.0}}, ShareOf::number), 400);
    CHECK(std::count(by_number.begin(), by_number.end(), 1e-3) == 100);
    CHECK(std::count(by_number.begin(), by_number.end(), 2e-3) == 200);
    CHECK(std::count(by_number.begin(), by_number.end(), 5e-3) == 100);
    // Half the mass in each: of 1 and 2 mm, eight small ones for each large one.
    const auto by_mass = physics::diameters_of(physics::listed_sizes({{1e-3, 0.5}, {2e-3, 0.5}}, ShareOf::mass), 900);
    CHECK(std::count(by_mass.begin(), by_mass.end(), 1e-3) == 800);
}

TEST_CASE("a sieve curve is met at its points and is straight in the logarithm between them")
{
    const std::vector<physics::SizePoint> curve{{1e-3, 0.0}, {2e-3, 0.3}, {4e-3, 1.0}};
    const auto of_mass = physics::diameters_of(physics::sieved_sizes(curve, ShareOf::mass), 200000);
    // Midpoints of so many shares: the mass of half a particle, of the largest 4^3 of the mean of about 3, is 1e-4 at most.
    CHECK(std::abs(mass_passing(of_mass, 2e-3) - 0.3) < 1e-4);
    CHECK(std::abs(mass_passing(of_mass, std::sqrt(2.0) * 2e-3) - 0.65) < 1e-4);
    const auto sizes = physics::sieved_sizes(curve, ShareOf::number);
    CHECK(physics::diameter_at(sizes, 0.3) == test::relative(2e-3).epsilon(1e-12));
    CHECK(physics::diameter_at(sizes, 0.65) == test::relative(std::sqrt(2.0) * 2e-3).epsilon(1e-12));
    CHECK(physics::diameter_at(sizes, 0.0) == test::relative(1e-3).epsilon(1e-12));
    CHECK(physics::diameter_at(sizes, 1.0) == test::relative(4e-3).epsilon(1e-12));
}

TEST_CASE("lognormal sizes have their median, their deviation and, by Hatch and Choate, their median of mass")
{
    const physics::LognormalSizes wide{2e-3, 1.3, 1e-4, 4e-2}; // ends beyond eleven deviations
    const auto sizes = physics::lognormal_sizes(wide, ShareOf::number);
    CHECK(physics::diameter_at(sizes, 0.5) == test::relative(2e-3).epsilon(1e-12));
    CHECK(physics::diameter_at(sizes, 0.841344746068543) == test::relative(2.6e-3).epsilon(1e-12)); // one deviation up
    const auto of_mass = physics::diameters_of(physics::lognormal_sizes(wide, ShareOf::mass), 100000);
    CHECK(std::abs(mass_passing(of_mass, 2e-3) - 0.5) < 1e-3); // the tail beyond the last midpoint has some 1e-4 of the mass
    const auto cut = physics::diameters_of(physics::lognormal_sizes({2e-3, 1.3, 1.8e-3, 2.2e-3}, ShareOf::number), 1000);
    CHECK(cut.front() > 1.8e-3);
    CHECK(cut.back() < 2.2e-3);
}

TEST_CASE("distributions that say nothing are refused")
{
    CHECK_THROWS_AS((void)physics::listed_sizes({{1e-3, 0.0}, {2e-3, 0.0}}, ShareOf::number), core::ConfigError);
    CHECK_THROWS_AS((void)physics::listed_sizes({{1e-3, 1.0}, {2e-3, -0.1}}, ShareOf::number), core::ConfigError);
    CHECK_THROWS_AS((void)physics::listed_sizes({{-1e-3, 1.0}, {2e-3, 1.0}}, ShareOf::number), core::ConfigError);
    CHECK_THROWS_AS((void)physics::sieved_sizes({{1e-3, 0.1}, {2e-3, 1.0}}, ShareOf::mass), core::ConfigError);
    CHECK_THROWS_AS((void)physics::sieved_sizes({{1e-3, 0.0}, {2e-3, 0.6}, {3e-3, 0.5}, {4e-3, 1.0}}, ShareOf::mass), core::ConfigError);
    CHECK_THROWS_AS((void)physics::lognormal_sizes({2e-3, 1.0, 1e-3, 4e-3}, ShareOf::mass), core::ConfigError);
    CHECK_THROWS_AS((void)physics::lognormal_sizes({2e-3, 1.1, 2e-2, 4e-2}, ShareOf::mass), core::ConfigError);
}

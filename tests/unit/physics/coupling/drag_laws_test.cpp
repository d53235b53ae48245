// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/drag_laws.hpp"
#include "tests/support/relative.hpp"
#include <array>
#include <doctest/doctest.h>

namespace {

constexpr double pi = std::numbers::pi;

/// 1 mm in water, Re = rho phi |u-v| d / mu.
physics::DragInput water(double reynolds, double phi) { return {reynolds * 1e-3 / phi, phi, 1e-3, 1000.0, 1e-3}; }

} // namespace

TEST_CASE("the laws fitted to resolved flow have the numbers of their printed equations")
{
    // Worked out from the equations as printed at phi = 0.5, Re = 100: F = 50.413428 (Beetstra), chi = 3.191784 (Rong), F = 81.414156
    // with the mean pressure gradient (Tenneti).
    CHECK(physics::drag_beetstra(water(100, 0.5)) == test::relative(2.3756768155593818e-4).epsilon(1e-12));
    CHECK(physics::drag_rong(water(100, 0.5)) == test::relative(2.210540982622748e-4).epsilon(1e-12));
    CHECK(physics::drag_tenneti(water(100, 0.5)) == test::relative(1.918275867554554e-4).epsilon(1e-12));
}

TEST_CASE("the laws fitted to resolved flow have their creeping limits, finite at zero slip")
{
    const double stokes = 3.0 * pi * 1e-6, phi = 0.5, solid = 0.5;
    // Carman-Kozeny's 10 C / phi^2 with the term of dilute arrays; Dalla Valle's 23.04 / 24 with chi = 2.65 (phi + 1).
    CHECK(physics::drag_beetstra(water(0, phi)) ==
          test::relative(stokes * phi * (10 * solid / (phi * phi) + phi * phi * (1 + 1.5 * std::sqrt(solid)))).epsilon(1e-12));
    // exp(-(1.5 + 12)^2 / 2) is nothing.
    CHECK(physics::drag_rong(water(0, phi)) == test::relative(stokes * 0.96 * std::pow(phi, 1 - 2.65 * 1.5)).epsilon(1e-12));
    for (const auto law : {physics::drag_beetstra, physics::drag_tenneti})
        CHECK(law(water(0, 1.0)) == test::relative(stokes).epsilon(1e-12)); // one sphere
}

TEST_CASE("whole force of creeping flow through a random array is that of Hill, Koch and Ladd")
{
    // 10 C / (1 - C)^3 for C above 0.4 (Journal of Fluid Mechanics 448, 2001), good to some per cent; the fits claim no more than 10 %.
    for (const double solid : {0.4, 0.5, 0.6}) {
        const double phi = 1 - solid, published = 10 * solid / (phi * phi * phi);
        for (const auto law : {physics::drag_beetstra, physics::drag_tenneti}) {
            const double whole = law(water(0, phi)) / (3.0 * pi * 1e-6 * phi * phi); // over 3 pi mu d U, with V (-grad p)
            CHECK(std::abs(whole / published - 1) < 0.12);
        }
    }
}

TEST_CASE("the laws agree in beds as far as their authors say")
{
    // Tenneti and others find themselves up to 30 % below Beetstra at Re = 300 and within 10 % in creeping flow.
    for (const double solid : {0.2, 0.3, 0.4, 0.5}) {
        CHECK(std::abs(physics::drag_tenneti(water(0.01, 1 - solid)) / physics::drag_beetstra(water(0.01, 1 - solid)) - 1) < 0.10);
        const double fast = physics::drag_tenneti(water(300, 1 - solid)) / physics::drag_beetstra(water(300, 1 - solid));
        CHECK(fast > 0.64);
        CHECK(fast < 0.72);
    }
    // A packed bed: Ergun's 20 %.
    for (const double reynolds : {20.0, 100.0, 300.0})
        for (const auto law : {physics::drag_beetstra, physics::drag_rong, physics::drag_di_felice})
            CHECK(std::abs(law(water(reynolds, 0.4)) / physics::drag_ergun(water(reynolds, 0.4)) - 1) < 0.2);
}

TEST_CASE("every law is smooth in the slip, and each name calls its own law")
{
    using physics::DragLaw;
    const auto call = [](DragLaw chosen, const physics::DragInput& in) {
        return physics::with_drag_law(chosen, [&](const auto& law) { return law(in); });
    };
    for (const DragLaw law : {DragLaw::di_felice, DragLaw::gidaspow_smooth, DragLaw::beetstra, DragLaw::rong, DragLaw::tenneti,
                              DragLaw::wen_yu, DragLaw::ergun})
        for (const double phi : {0.4, 0.8, 1.0}) {
            CHECK(std::isfinite(call(law, water(0, phi))));
            CHECK(call(law, water(50, phi)) == test::relative(call(law, water(50.0001, phi))).epsilon(1e-5)); // grows by less than Re does
        }
    CHECK(call(DragLaw::beetstra, water(10, 0.6)) == physics::drag_beetstra(water(10, 0.6)));
    CHECK(call(DragLaw::rong, water(10, 0.6)) == physics::drag_rong(water(10, 0.6)));
    CHECK(call(DragLaw::tenneti, water(10, 0.6)) == physics::drag_tenneti(water(10, 0.6)));
    CHECK(call(DragLaw::wen_yu, water(10, 0.6)) == physics::drag_wen_yu(water(10, 0.6)));
    CHECK(call(DragLaw::ergun, water(10, 0.6)) == physics::drag_ergun(water(10, 0.6)));
    CHECK(call(DragLaw::gidaspow_smooth, water(10, 0.6)) == physics::drag_gidaspow_smooth(water(10, 0.6)));
    CHECK(call(DragLaw::schiller_naumann, water(10, 0.6)) == physics::drag_schiller_naumann(water(10, 0.6)));
}

TEST_CASE("in a mixture equal grains feel the law of equal grains, and large ones more than their share")
{
    for (const double phi : {0.4, 0.7, 1.0}) CHECK(physics::mixture_share(1.0, phi) == test::relative(1.0).epsilon(1e-15));
    // phi = 0.5, y = 2: (1 + 2 + 0.256) / 1.032.
    CHECK(physics::mixture_share(2.0, 0.5) == test::relative(3.256 / 1.032).epsilon(1e-14));
    const auto law = [](const physics::DragInput& in) { return physics::drag_beetstra(in); };
    const physics::DragInput in = water(10, 0.5);
    CHECK(physics::drag_in_mixture(law, in, in.diameter) == test::relative(law(in)).epsilon(1e-14));
    // In a packed bed the pressure drop shares itself out: the force of all grains is that of equal grains of the mean diameter. Two
    // sizes, as much of each by volume: mean = 2 / (1 / d1 + 1 / d2).
    const double d1 = 1e-3, d2 = 2e-3, mean = 2 / (1 / d1 + 1 / d2), phi = 0.4;
    const auto force_per_volume = [&](double d, double within) {
        physics::DragInput one = water(0, phi);
        one.diameter = d;
        return physics::drag_in_mixture(law, one, within) / (pi / 6 * d * d * d);
    };
    const double mixed = 0.5 * (force_per_volume(d1, mean) + force_per_volume(d2, mean));
    // Their formula keeps that to its cubic term, 0.064 phi (1.1 - 1).
    CHECK(mixed / force_per_volume(mean, mean) == test::relative(1.0).epsilon(0.005));
}

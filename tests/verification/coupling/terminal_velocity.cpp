// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// One grain in undisturbed fluid against tables and exact solutions: how fast it settles by each drag law, and how it gets there.
#include "physics/coupling/added_mass.hpp"
#include "physics/coupling/history_force.hpp"
#include "tests/support/lone_grain.hpp"
#include "tests/support/relative.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using core::Vec3;
using physics::DragLaw;

namespace {

constexpr double pi = std::numbers::pi;

struct Settling {
    const char* name;
    double diameter, density, fluid_density, viscosity; ///< viscosity dynamic
    double velocity, t50, t95, t99;                     ///< downwards, with added mass [m/s, s]
    double bare50, bare95, bare99;                      ///< without [s]; 0: not in the table
};

physics::CouplingParameters parameters_of(const Settling& s)
{
    physics::CouplingParameters p;
    p.drag = DragLaw::schiller_naumann;
    p.fluid_density = s.fluid_density;
    p.viscosity = s.viscosity;
    p.gravity = {0, -9.81, 0};
    p.torque = false;
    return p;
}

/// Times at which the grain has 50, 95 and 99 % of `velocity`.
std::array<double, 3> times_of(const Settling& s, const physics::CouplingParameters& p, double dt)
{
    test::LoneGrain grain(p, s.diameter, s.density);
    std::array<double, 3> times{};
    const std::array share{0.5, 0.95, 0.99};
    double t = 0, before = 0;
    for (std::size_t next = 0; next < 3; t += dt) {
        grain.step(dt);
        const double now = -grain.velocity().y() / s.velocity;
        for (; next < 3 && now >= share[next]; ++next) times[next] = t + dt * (share[next] - before) / (now - before);
        before = now;
    }
    return times;
}

} // namespace

TEST_CASE("a grain that gas lifts falls as MFIX's case DEM06 says")
{
    // NUMERICS C4.1: 0.1 mm, 2000 kg/m3, gas of 1.2 kg/m3 that rises with 0.40 m/s, no buoyancy in its equation of motion.
    const std::pair<double, double> table[] = {{0.01, -.01255261}, {0.02, -.02238662}, {0.05, -.04078891},
                                               {0.10, -.05263133}, {0.15, -.05603496}, {0.20, -.05701037},
                                               {0.25, -.05728967}, {0.30, -.05736962}, {0.35, -.05739251}};
    physics::CouplingParameters p = parameters_of({"", 1e-4, 2000, 1.2, 1.8e-5, 0, 0, 0, 0, 0, 0, 0});
    p.added_mass = 0;
    p.gravity = {0, -9.80665, 0};
    test::LoneGrain grain(p, 1e-4, 2000);
    grain.set_fluid({0, 0.4, 0});
    const double dt = 1e-5;
    int n = 0;
    double worst = 0;
    for (const auto& [t, v] : table) {
        for (; n < std::lround(t / dt); ++n) grain.step(dt);
        worst = std::max(worst, std::abs(grain.velocity().y() / v - 1));
    }
    std::printf("DEM06: largest error %.1e\n", worst);
    // Drag frozen over a step of 1e-5 s of a relaxation of 0.06 s; the table's own last digits are 1e-7.
    CHECK(worst < 1e-3);
}

TEST_CASE("six grains settle as the table of settling says, with and without added mass")
{
    const Settling table[] = {
        {"sand 0.1 mm", 1e-4, 2650, 1000, 1e-3, 0.007970, .00105, .00441, .00673, .00089, .00371, .00566},
        {"sand 0.5 mm", 5e-4, 2650, 1000, 1e-3, 0.078447, .00929, .03496, .05205, .00782, .02941, .04379},
        {"2 mm, s 2", 2e-3, 2000, 1000, 1e-3, 0.208384, .03088, .11174, .16489, .02471, .08939, .13191},
        {"3 mm, s 2", 3e-3, 2000, 1000, 1e-3, 0.292388, .04307, .15502, .22848, .03445, .12401, .18278},
        {"steel in oil", 1e-3, 7800, 970, 0.373, 0.009860, .00085, .00364, .00558, .00080, .00342, .00526},
        {"light 0.2 mm", 2e-4, 1.2, 1000, 1e-3, -0.016279, .00055, .00223, .00337, 0, 0, 0},
    };
    for (const Settling& s : table) {
        physics::CouplingParameters p = parameters_of(s);
        const double dt = s.t50 / 500;
        const auto check = [&](const std::array<double, 3>& found, const std::array<double, 3>& wanted) {
            // The table is printed to 1e-5 s, of which the last digit may be off by one; 0.2 % is the frozen drag's.
            for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(found[k] - wanted[k]) < 1e-5 + 0.002 * wanted[k]);
        };
        const auto times = times_of(s, p, dt);
        std::printf("%-12s t50 %.5f t95 %.5f t99 %.5f s\n", s.name, times[0], times[1], times[2]);
        check(times, {s.t50, s.t95, s.t99});
        if (s.bare50 > 0) {
            p.added_mass = 0;
            check(times_of(s, p, dt), {s.bare50, s.bare95, s.bare99});
        }
        test::LoneGrain grain(parameters_of(s), s.diameter, s.density);
        for (int n = 0; n < 20; ++n) grain.step(s.t99);                           // however long the steps
        CHECK(-grain.velocity().y() == test::relative(s.velocity).epsilon(1e-4)); // printed to four digits
    }
}

TEST_CASE("by every drag law a grain ends where drag is its weight")
{
    using enum DragLaw;
    for (const DragLaw law : {di_felice, gidaspow, kawaguchi, gidaspow_smooth, schiller_naumann, beetstra, rong, tenneti, wen_yu, ergun})
        for (const double fraction : {0.45, 0.75, 1.0})
            for (const double diameter : {5e-5, 2e-3}) {
                if (law == ergun && fraction == 1.0) continue; // of packed beds: in creeping flow nothing is left
                physics::CouplingParameters p = parameters_of({"", diameter, 2650, 1000, 1e-3, 0, 0, 0, 0, 0, 0, 0});
                p.drag = law;
                test::LoneGrain grain(p, diameter, 2650);
                grain.fraction = fraction;
                for (int n = 0; n < 400; ++n) grain.step(0.02);
                const double v = grain.velocity().norm(), weight = pi / 6 * std::pow(diameter, 3) * 1650 * 9.81;
                CHECK(physics::drag_coefficient(p, v, fraction, diameter) * v == test::relative(weight).epsilon(1e-9)); // converged
            }
}

TEST_CASE("added mass of Zuber slows the start by what other grains around make of it")
{
    physics::CouplingParameters p = parameters_of({"", 2e-3, 2000, 1000, 1e-3, 0, 0, 0, 0, 0, 0, 0});
    for (const double fraction : {1.0, 0.75, 0.6}) {
        p.added_mass_law = physics::AddedMassLaw::zuber;
        test::LoneGrain grain(p, 2e-3, 2000);
        grain.fraction = fraction;
        const double dt = 1e-7; // nothing is felt of drag
        grain.step(dt);
        const double expected = -9.81 * dt * (2000 - 1000) / (2000 + physics::added_mass_zuber(1 - fraction) * 1000);
        CHECK(grain.velocity().y() == test::relative(expected).epsilon(1e-4)); // creeping drag: K dt / m = 1e-6
    }
}

TEST_CASE("a light grain rises from rest in creeping flow as Basset's equation says")
{
    // (m + m_a) dv/dt = W - K v - c int v' / sqrt(t - s): with x^2 (m + m_a) + c sqrt(pi) x + K = (m + m_a)(x + a)(x + b),
    // v = W/K (1 - (b exp(a^2 t) erfc(a sqrt t) - a exp(b^2 t) erfc(b sqrt t)) / (b - a)), a and b real below s = 0.625.
    const double d = 1e-4, rho = 1000, mu = 1.0, density = 300, volume = pi / 6 * d * d * d;
    physics::CouplingParameters p = parameters_of({"", d, density, rho, mu, 0, 0, 0, 0, 0, 0, 0});
    p.history = true;
    const double mass = (density + 0.5 * rho) * volume, drag = 3 * pi * mu * d;
    const double half = 0.5 * physics::history_factor(d, rho, mu) * std::sqrt(pi) / mass;
    const double root = std::sqrt(half * half - drag / mass), a = half - root, b = half + root;
    const auto decay = [](double x, double t) { return std::exp(x * x * t) * std::erfc(x * std::sqrt(t)); };
    const double weight = (rho - density) * volume * 9.81, viscous = d * d * rho / mu;
    for (const int steps : {50, 200}) {
        test::LoneGrain grain(p, d, density);
        const double end = 0.5 * viscous, dt = end / steps;
        double worst = 0;
        for (int n = 1; n <= steps; ++n) {
            grain.step(dt);
            const double t = n * dt, exact = weight / drag * (1 - (b * decay(a, t) - a * decay(b, t)) / (b - a));
            if (n >= 5) worst = std::max(worst, std::abs(grain.velocity().y() / exact - 1));
        }
        p.history = false;
        test::LoneGrain without(p, d, density);
        p.history = true;
        for (int n = 0; n < steps; ++n) without.step(dt);
        const double exact = weight / drag * (1 - (b * decay(a, end) - a * decay(b, end)) / (b - a));
        std::printf("Basset, %d steps: largest error %.2f %%; without history %.1f %% too fast\n", steps, 100 * worst,
                    100 * (without.velocity().y() / exact - 1));
        // The tail is good to 0.4 %, and long times are faded out: 0.76 sqrt(t nu / 1000 d^2) = 1.7 % of the history.
        CHECK(worst < (steps == 50 ? 0.03 : 0.015));
        CHECK(without.velocity().y() / exact - 1 > 0.1);
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What each coupling mode costs in accuracy: error against time step for free, sticking and locked grains, soft and stiff
// drag, little and much mass; printed as a table (NUMERICS C5.7). The same in space: configs/coupling_modes.
#include "core/base/error.hpp"
#include "tests/support/one_cell.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>
#include <iomanip>
#include <numbers>
#include <string>
#include <vector>

using physics::Mode;
using testing::CellScene;
using testing::Contact;
using testing::OneCell;

namespace {

constexpr double period = 0.18; // [s]
constexpr int samples = 45;     // in a period; every step below divides the time between two
constexpr std::array steps{4e-3, 2e-3, 1e-3, 5e-4};
constexpr std::array modes{Mode::pipelined, Mode::coarse, Mode::concurrent, Mode::iterated};

struct Case {
    Contact contact;
    double loading;   ///< M
    double drag_rate; ///< K / m [1/s]
};

CellScene scene_of(const Case& c, Mode mode, double dt)
{
    CellScene scene;
    scene.stiffness = c.drag_rate * dt;
    scene.loading = c.loading;
    scene.contact = c.contact;
    scene.friction = 4.0; // [m/s2]: the fluid alone would reach 35
    scene.motion = testing::Motion::transverse;
    scene.mode = mode;
    scene.dt = dt;
    scene.flow = [](double t) { return std::sin(2.0 * std::numbers::pi * t / period); };
    return scene;
}

struct Curve {
    std::vector<double> speeds; ///< of fluid and grains
    double closure = 0.0, fastest = 0.0;
};

/// Two periods from rest.
Curve curve_of(const Case& c, Mode mode, double dt)
{
    OneCell cell(scene_of(c, mode, dt));
    const int every = int(std::lround(period / samples / dt));
    Curve curve;
    for (int n = 1; n <= 2 * samples * every; ++n) {
        cell.step();
        curve.closure = std::max(curve.closure, cell.closure());
        curve.fastest = std::max(curve.fastest, cell.fastest());
        if (n % every == 0) curve.speeds.insert(curve.speeds.end(), {cell.fluid_velocity(), cell.grain_velocity(0)});
    }
    return curve;
}

/// Root mean square of the error over that of the speeds themselves: 1 is what standing still would make.
double error_of(const Curve& curve, const Curve& exact)
{
    double squares = 0.0, all = 0.0;
    for (std::size_t n = 0; n < exact.speeds.size(); ++n) {
        squares += std::pow(curve.speeds[n] - exact.speeds[n], 2);
        all += std::pow(exact.speeds[n], 2);
    }
    return std::sqrt(squares / all);
}

bool runs(const Case& c, Mode mode, double dt)
{
    const double s = CellScene{}.density_ratio, phi = s / (s + c.loading);
    return physics::holds(mode, {c.drag_rate * dt, c.loading, physics::added_mass_amplification(phi, s, 0.5), 1.0 - phi});
}

std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const Contact contact : {Contact::none, Contact::stick_slip, Contact::locked})
        for (const double loading : {0.01, 0.05, 3.0, 2000.0})
            for (const double rate : {2.5, 10.0, 100.0, 1e3, 1e4, 1e6, 2.5e6})
                if (rate < 2e6 || contact != Contact::stick_slip) all.push_back({contact, loading, rate});
    return all;
}

const char* name(Contact contact) { return contact == Contact::none ? "free" : contact == Contact::locked ? "locked" : "stick-slip"; }

} // namespace

TEST_CASE("every mode that is not refused is bounded, and its error falls with the step")
{
    std::printf("| grains | M | K/m [1/s] | mode |");
    for (const double dt : steps) std::printf(" %g ms |", 1e3 * dt);
    std::printf("\n|---|---|---|---|---|---|---|---|\n");
    for (const Case& c : cases()) {
        const Curve exact = curve_of(c, Mode::iterated, 1e-5);
        for (const Mode mode : modes) {
            std::vector<double> errors;
            std::string line;
            for (const double dt : steps) {
                if (!runs(c, mode, dt)) {
                    line += " refused |";
                    continue;
                }
                const Curve curve = curve_of(c, mode, dt);
                errors.push_back(error_of(curve, exact));
                line += core::text(" ", std::setprecision(2), errors.back(), " |");
                INFO(std::string(name(c.contact)), " M ", c.loading, " K/m ", c.drag_rate, " ", std::string(physics::name(mode)), " dt ",
                     dt);
                CHECK(curve.closure < 1e-12); // round-off of some thousand additions, relative to all momentum moved
                // The fluid without grains reaches 1 m/s. Drag and friction only take, but what they shift in phase may start from
                // rest 5 % faster.
                CHECK(curve.fastest < 1.1);
                // Where `auto` makes a single pass.
                if (c.drag_rate * dt <= 5.0) CHECK(errors.back() < 0.2);
            }
            if (errors.empty()) continue;
            std::printf("| %s | %g | %g | `%s` |%s\n", name(c.contact), c.loading, c.drag_rate, physics::name(mode), line.c_str());
            // First order; where the step is far longer than the time of drag, only the start from rest is in error, and does not fall.
            CHECK((errors.back() < 0.6 * errors.front() || errors.back() < 0.01));
        }
    }
}

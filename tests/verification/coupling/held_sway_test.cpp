// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Contacts hold a bed like springs: it may sway, and the fluid with it. The delay of the coupling must not feed the motion.
#include "physics/coupling/added_mass.hpp"
#include "physics/coupling/contact_share.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/coupling/true_up.hpp"
#include "tests/support/one_cell.hpp"
#include "tests/support/relative.hpp"
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>
#include <functional>

namespace {

using Tell = std::function<double(double now, double told)>;

constexpr double solid = 0.6, ratio = 2.0, dt = 1.0;
const physics::GrainCoupling grain{ratio * solid, solid, 0.0, physics::added_mass(0.5, 1.0, solid)};

/// All grains of a cell on one spring, held (their weight is carried), with fluid that nothing else moves.
/// @param angle  Of the sway in one step, without the fluid [rad].
/// @return growth of the amplitude in each step.
double growth(double angle, const Tell& tell)
{
    const double mass = grain.mass + grain.added_mass, spring = mass * angle * angle, fluid_mass = 1.0 - solid;
    const physics::GrainResponse response = response_to_velocity(grain, physics::predictor_yield(1.0));
    double x = 0, v = 1, u = 0, owed = 0, acceleration = 0, told = 0, first = 0, last = 0;
    constexpr int steps = 600, parts = 200;
    for (int n = 0; n < steps; ++n) {
        told = tell(acceleration, told);
        const double untold = dt * (acceleration - told), force = owed / dt + grain.added_mass * told, before = v;
        double contact = 0;
        for (int k = 0; k < parts; ++k) {
            x += 0.5 * v * dt / parts;
            v += dt / parts * (force - spring * x) / mass;
            contact -= dt / parts * spring * x;
            x += 0.5 * v * dt / parts;
        }
        const double received = grain.mass * (v - before) - owed - contact, miss = -dt * acceleration;
        const physics::FluidPush push{0.0, 0.0, received + response.added * untold, u, u, miss};
        const double du = predicted_change(push, fluid_mass, 1.0 - solid, response, dt);
        owed = physics::owed_impulse({0, 0, 0, du, 0, miss + untold}, solid, response, response, dt);
        acceleration = du / dt;
        u += du;
        const double energy = 0.5 * mass * v * v + 0.5 * spring * x * x;
        if (n >= steps / 2 - 50 && n < steps / 2) first += energy;
        if (n >= steps - 50) last += energy;
    }
    return std::log(last / first) / steps; // of the square over half of the steps
}

double worst(const Tell& tell)
{
    double most = -1;
    for (double angle = 0.1; angle < 40; angle *= 1.03) most = std::max(most, growth(angle, tell));
    return most / (grain.added_mass / (grain.mass + grain.added_mass));
}

} // namespace

TEST_CASE("a swaying bed is hardly fed by the delay of the fluid's acceleration, whatever its frequency")
{
    const double free = worst([](double now, double) { return now; });
    const double held = worst([](double now, double told) { return physics::told_acceleration(now, told, 1.0); });
    std::printf("growth of a sway in each step, over a / (m + a): told at once %.3f, when held %.3f\n", free, held);
    // Linear theory with the fluid's part r = 0.43: 2 r times the largest of -Im G sin^2(angle / 2) / angle, 0.93 and 0.066.
    CHECK(free > 0.4); // the test of the test; the sway is not small against the step there
    CHECK(held < 0.07);
}

TEST_CASE("a grain is told all: at once if it is free, a quarter of the rest in each step if it is held")
{
    CHECK(physics::told_acceleration(3.0, -1.0, 0.0) == 3.0);
    double told = 0, rest = 0, impulse = 0; // per added mass
    for (int n = 0; n < 200; ++n) {
        const double now = n < 10 ? 1.0 : 0.0; // what the fluid gives: ten units
        told = physics::told_acceleration(now, told, 1.0);
        impulse += told + rest;
        rest = now - told; // owed
    }
    CHECK(impulse == test::relative(10.0));
}

namespace {

/// Bed and fluid of one cell after a jolt, on springs that drag leans on: growth of the sway in each step.
double growth(const testing::CellScene& scene)
{
    testing::OneCell cell(scene);
    const double angle = std::sqrt(scene.stiffness / scene.softness); // of the grains alone in a step; with their fluid it is smaller
    const int steps = std::max(300, int(12.0 * std::numbers::pi * std::sqrt(1.0 + 1.0 / scene.loading) / angle)); // six sways
    double first = 0, last = 0;
    for (int n = 0; n < steps; ++n) {
        cell.step();
        double& most = n < steps / 2 ? first : last;
        if (n >= 20) most = std::max(most, cell.fastest()); // the jolt itself is over
    }
    return std::log(std::max(last, 1e-12) / std::max(first, 1e-12)) / (0.5 * steps); // a billionth of the jolt is at rest
}

} // namespace

TEST_CASE("a bed on springs that are soft against drag sways less and less with its fluid, in every mode that is not refused")
{
    double worst_held = -1, worst_refused = -1;
    for (const physics::Mode mode : {physics::Mode::pipelined, physics::Mode::coarse, physics::Mode::concurrent, physics::Mode::iterated})
        for (const auto motion : {testing::Motion::transverse, testing::Motion::confined})
            for (const double softness : {0.4, 0.7, 1.0, 3.0, 10.0, 100.0, 1e3})
                for (const double b : {0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 50.0, 300.0})
                    for (const double ratio : {1.05, 2.65, 20.0, 1000.0}) {
                        testing::CellScene scene;
                        scene.mode = mode;
                        scene.motion = motion;
                        scene.contact = testing::Contact::spring;
                        scene.softness = softness;
                        scene.stiffness = b;
                        const double phi = 0.4, loading = ratio * (1.0 - phi) / phi;
                        scene.density_ratio = ratio;
                        scene.loading = loading;
                        scene.gravity = 0.0;
                        scene.substeps = int(std::ceil(std::max(40.0, 4.0 * std::sqrt(b / softness))));
                        scene.flow = [](double t) { return t > 0.0015 && t < 0.0045 ? 1.0 : 0.0; };
                        physics::StabilityNumbers numbers{b, loading, physics::added_mass_amplification(phi, ratio, 0.5), 1.0 - phi};
                        numbers.softness = softness;
                        const double grows = growth(scene) * (ratio + 0.5) / 0.5; // over a / (m + a)
                        double& most = holds(mode, numbers) ? worst_held : worst_refused;
                        most = std::max(most, grows);
                    }
    std::printf("growth of a sway in each step, over a / (m + a): %.4f where it is taken for calm, %.4f where refused\n", worst_held,
                worst_refused);
    CHECK(worst_held < 0.035);  // what held grains are told late of the fluid's acceleration: half of the above, for that is energy
    CHECK(worst_refused > 0.1); // the test of the test
}

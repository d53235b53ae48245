// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Oscillating flow in a round pipe against Womersley's solution (NUMERICS C1.5).
#include "physics/fluid/womersley.hpp"
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

/// Radius 1, forcing cos(t): the velocity at a radius.
double exact(double alpha, double r, double time) { return physics::WomersleyFlow({1.0, 1 / (alpha * alpha), 1.0, 1.0}).velocity(r, time); }

/// Error of the axial profile after one period over the largest velocity mean, starting from the exact profile.
double profile_error(int across, double alpha, int steps)
{
    physics::FluidParameters water;
    water.viscosity = 1 / (alpha * alpha);
    water.drive = physics::harmonic_drive(core::Vec3::UnitX(), 1.0, 0.0);
    test::FluidRun run(test::pipe_across(across, 2.0, 2, 1), water);
    const auto solution = [&](double time) {
        return [=](const core::Vec3& x) { return core::Vec3(exact(alpha, std::hypot(x.y(), x.z()), time), 0, 0); };
    };
    run.start(solution(0));
    run.fluid().state().clock.steps_since_jump = 2; // the exact start is no jump
    double worst = 0, largest = 0;
    for (int n = 0; n < steps; ++n) {
        run.step(2 * std::numbers::pi / steps);
        worst = std::max(worst, run.velocity_error(solution(run.time())));
        largest = std::max(largest, run.velocity_error([](const core::Vec3&) { return core::Vec3::Zero().eval(); }));
    }
    MESSAGE("alpha ", alpha, ", ", across, " cells, ", steps, " steps: ", worst / largest);
    return worst / largest;
}

} // namespace

TEST_CASE("24 cells across give the profile at alpha = 5 to 1.5 %") { CHECK(profile_error(24, 5, 80) < 0.015); }

TEST_CASE("48 cells across give the profile at alpha = 10 to 1.5 %") { CHECK(profile_error(48, 10, 120) < 0.015); }

TEST_CASE("slow oscillations, alpha = 1 and 3, need few cells, and fast ones, alpha = 20, as many as their layer at the wall asks for")
{
    CHECK(profile_error(24, 1, 80) < 0.015);
    CHECK(profile_error(24, 3, 80) < 0.015);
    CHECK(profile_error(96, 20, 160) < 0.015);
}

TEST_CASE("the profile is second order in space")
{
    const double coarse = profile_error(16, 5, 160), fine = profile_error(32, 5, 160);
    CHECK(std::log2(coarse / fine) > 1.8);
}

TEST_CASE("the profile is second order in time")
{
    const auto axial = [](int steps) {
        physics::FluidParameters water;
        water.viscosity = 0.04;
        water.drive = physics::harmonic_drive(core::Vec3::UnitX(), 1.0, 0.0);
        test::FluidRun run(test::pipe_across(12, 2.0, 2, 1), water);
        run.start([](const core::Vec3& x) { return core::Vec3(exact(5, x.tail<2>().norm(), 0), 0, 0); });
        for (int n = 0; n < steps; ++n) run.step(4.0 / steps);
        std::vector<double> core_block;
        core::for_each_cell(run.mesh().geometry(0).cells, [&](int i, int j, int k) { core_block.push_back(run.velocity(0, i, j, k).x()); });
        return core_block;
    };
    const auto distance = [](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0;
        for (std::size_t n = 0; n < a.size(); ++n) sum += (a[n] - b[n]) * (a[n] - b[n]);
        return std::sqrt(sum);
    };
    const auto coarse = axial(20), middle = axial(40), fine = axial(80);
    CHECK(std::log2(distance(coarse, middle) / distance(middle, fine)) > 1.9);
}

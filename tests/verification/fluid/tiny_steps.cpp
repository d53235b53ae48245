// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Steps of 1e-9 s after normal ones change nothing and shake no pressure (NUMERICS D33).
#include "tests/support/fluid_run.hpp"
#include "tests/support/relative.hpp"
#include <cstdio>
#include <doctest/doctest.h>

namespace {

using core::Vec3;
constexpr double turn = 2 * std::numbers::pi, tiny = 1e-9;

physics::FluidParameters water(double viscosity)
{
    physics::FluidParameters p;
    p.density = 1;
    p.viscosity = viscosity;
    p.tolerances.pressure = 1e-8;
    return p;
}

core::MultiBlock wavy_box(int n, int thick, double third)
{
    const core::Box box{{0, 0, 0}, {turn, turn, turn * thick / n}, {n, n, thick}, {2, 1, 1}, {true, true, true}};
    return core::make_box(box, [=](const Vec3& x) { return test::wavy(x, 0.2, third); });
}

/// Root mean square of (q_{i-1} - 2 q_i + q_{i+1}) / 4 along the axes of index space: q of a checkerboard, h^2 of what is smooth.
double roughness(const test::FluidRun& run)
{
    const auto& pressure = run.fluid().state().pressure;
    return std::sqrt(run.mean([&](core::LocalBlock b, int i, int j, int k) {
        const auto p = pressure.on(b);
        const core::Extents n = p.extents();
        double sum = 0;
        if (i > 0 && i + 1 < n.ni) sum += std::pow(0.25 * (p(i - 1, j, k) - 2 * p(i, j, k) + p(i + 1, j, k)), 2);
        if (j > 0 && j + 1 < n.nj) sum += std::pow(0.25 * (p(i, j - 1, k) - 2 * p(i, j, k) + p(i, j + 1, k)), 2);
        if (k > 0 && k + 1 < n.nk) sum += std::pow(0.25 * (p(i, j, k - 1) - 2 * p(i, j, k) + p(i, j, k + 1)), 2);
        return sum;
    }));
}

double largest_pressure(const test::FluidRun& run)
{
    return run.largest([&](core::LocalBlock b, int i, int j, int k) { return run.fluid().state().pressure.on(b)(i, j, k); });
}

struct Case {
    const char* name;
    core::MultiBlock grid;
    physics::FluidParameters parameters;
    test::VectorFunction velocity;
    double dt;
};

std::vector<Case> cases()
{
    std::vector<Case> all;
    all.push_back({"vortices in two dimensions", wavy_box(24, 1, 0), water(0.02),
                   [](const Vec3& x) { return Vec3(-std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()), 0); }, 0.05});
    all.push_back({"vortices in three dimensions", wavy_box(16, 16, 0.5), water(0.0),
                   [](const Vec3& x) {
                       return Vec3(std::cos(x.z()) * Vec3(std::cos(x.x()) * std::sin(x.y()), -std::sin(x.x()) * std::cos(x.y()), 0));
                   },
                   0.1});
    auto driven = water(1e-3);
    driven.drive = physics::ConstantDrive{Vec3(1, 0, 0)};
    all.push_back({"swirl in a pipe", test::pipe_across(12, 2.0, 12, 2), driven,
                   [](const Vec3& x) {
                       const double fade = 1 - x.tail<2>().squaredNorm();
                       return Vec3(fade * Vec3(1 + 0.3 * std::sin(std::numbers::pi * x.x()), -x.z(), x.y()));
                   },
                   0.05});
    return all;
}

std::vector<Vec3> velocities(const test::FluidRun& run)
{
    std::vector<Vec3> all;
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b)
        core::for_each_cell(run.mesh().geometry(b).cells, [&](int i, int j, int k) { all.push_back(run.velocity(b, i, j, k)); });
    return all;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    double most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, (a[n] - b[n]).norm());
    return most;
}

} // namespace

TEST_CASE("steps of 1e-9 s after normal ones change nothing and shake no pressure")
{
    for (auto& c : cases()) {
        test::FluidRun run(c.grid, c.parameters);
        run.start(c.velocity);
        for (int n = 0; n < 10; ++n) run.step(c.dt);
        auto last = velocities(run);
        run.step(c.dt);
        const double acceleration = largest_difference(velocities(run), last) / c.dt;
        const double pressure = largest_pressure(run), rough = roughness(run);
        last = velocities(run);
        for (int n = 1; n <= 50; ++n) {
            run.step(tiny);
            // The flow goes on changing as fast as before; twice that allows for what 50 ns leave of a mean over a step.
            CHECK(largest_difference(velocities(run), last) < n * tiny * 2 * acceleration);
            // Pressure is half a normal step later, in which it changes by some per cent.
            CHECK(largest_pressure(run) == test::relative(pressure).epsilon(0.1));
            CHECK(roughness(run) < 1.1 * rough);
        }
        std::printf("%-29s: acceleration %.3f, %.3f in tiny steps; pressure %.3e -> %.3e; roughness %.3e -> %.3e\n", c.name, acceleration,
                    largest_difference(velocities(run), last) / (50 * tiny), pressure, largest_pressure(run), rough, roughness(run));
        for (int n = 0; n < 3; ++n) run.step(c.dt);
        CHECK(largest_pressure(run) < 1.1 * pressure);
        CHECK(roughness(run) < 1.2 * rough);
    }
}

TEST_CASE("flux that faces remember feeds no energy: a long inviscid flow to and fro never has more than the drive gave it")
{
    const double g = 33.3, top = 1.5, diameter = 0.05, wave = turn / diameter, step = 0.25 * diameter / 12 / top;
    physics::FluidParameters p = water(0.0);
    p.drive = physics::ReversingDrive{Vec3(g, 0, 0), top};
    p.tolerances.pressure = 1e-6;
    test::FluidRun run(test::pipe_across(12, diameter, 12, 2), p);
    run.start([=](const Vec3& x) {
        const Vec3 s = (wave * x).array().sin(), c = (wave * x).array().cos();
        return Vec3(0.1 * Vec3(s.y() * c.z(), s.x() * c.z(), c.x() * c.y() - s.x() * s.y()));
    });
    const auto speed_of = [&](core::LocalBlock b, int i, int j, int k) { return run.velocity(b, i, j, k).norm(); };
    const auto along = [&](core::LocalBlock b, int i, int j, int k) { return run.velocity(b, i, j, k).x(); };
    const auto half_square = [&](core::LocalBlock b, int i, int j, int k) { return 0.5 * run.velocity(b, i, j, k).squaredNorm(); };
    const auto energy = [&] { return run.mean(half_square); };
    auto& clock = run.fluid().state().clock;
    double given = energy(), speed = run.mean(along), excess = -1.0, fastest = 0.0;
    const std::array lengths{1.0, 0.3, 0.1, 1e-6, 0.7, 0.2, 0.2}; // of steps: faces remember in most of them
    while (run.time() < 0.8) {
        const double sign = clock.drive.sign, before = speed, dt = step * lengths[std::size_t(clock.step) % lengths.size()];
        run.step(dt);
        speed = run.mean(along);
        given += dt * sign * g * 0.5 * (before + speed);
        if (physics::turn_if_due(p.drive, speed, clock.time, clock.drive)) clock.steps_since_jump = 0;
        excess = std::max(excess, energy() - given);
        fastest = std::max(fastest, run.largest(speed_of));
    }
    std::printf("to and fro for %.2f s, %d steps: energy at most %.1e above what was given, largest speed %.2f m/s\n", run.time(),
                int(clock.step), excess, fastest);
    CHECK(excess < 1e-6 * top * top); // the solver's tolerance
    CHECK(fastest < 1.3 * top);
}

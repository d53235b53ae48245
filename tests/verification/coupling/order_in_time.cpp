// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Grains that meet nobody in a fluid that is driven to and fro: velocities and places of grains and the momentum of the fluid are second
// order in time in every mode. Where the fluid moves is first order: impulses are put down at the places where steps end.
// ctest: timeout=120
#include "core/base/random.hpp"
#include "tests/support/coupled_run.hpp"
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>
#include <numeric>

using namespace test;

namespace {

constexpr double diameter = 0.8e-3; // [m]
constexpr int sub_steps = 12 * 64;  // of all runs: time steps are whole numbers of them

struct State {
    std::vector<double> momentum, velocity, place, fluid; ///< over mass [m/s], [m/s], [m], [m/s]
};

/// Sixty-four grains around the points of a lattice, as far as they stay apart.
std::vector<Vec3> places()
{
    std::vector<Vec3> all;
    core::for_each({0, 0, 0}, {4, 4, 4}, [&](int i, int j, int k) {
        const auto u = core::random_uniform(7, std::int64_t(all.size()), 0);
        all.push_back(2e-3 * Vec3(i + 0.3 + 0.4 * u[0], j + 0.3 + 0.4 * u[1], k + 0.3 + 0.4 * u[2]));
    });
    return all;
}

/// @param parts  Sub-steps in a time step.
State end_of(io::CouplingMode mode, int parts)
{
    CoupledBox box;
    box.size = 8e-3 * Vec3::Ones();
    box.cells = {8, 8, 8};
    box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
    box.diameter = diameter;
    box.density_ratio = 2.5;
    box.viscosity = 1e-5;
    box.pressure_gradient = 2000.0;
    box.gravity = {0, 0, -3.0};
    box.stiffness = 1.0; // nobody meets anybody: it decides how long sub-steps are
    box.mode = mode;
    box.tolerance = 1e-11;
    io::Scene scene = scene_of(box, 1);
    scene.fluid->drive->frequency = 10.0;
    scene.run.time_step = (parts + 1e-6) * CoupledRun(scene).world().grains()->step();
    CoupledRun run(scene);
    run.place(places());
    run.start();
    for (int n = 0; n < sub_steps / parts; ++n) run.step();
    CHECK(run.world().sub_steps() == parts);
    State state;
    for (int c = 0; c < 3; ++c)
        core::for_each_cell({8, 8, 8}, [&](int i, int j, int k) {
            state.fluid.push_back(run.world().fluid()->state().velocity.on(0).component(c)(i, j, k));
        });
    for (std::size_t c = 0; c < 3; ++c)
        state.momentum.push_back(
            std::accumulate(state.fluid.begin() + 512 * std::ptrdiff_t(c), state.fluid.begin() + 512 * std::ptrdiff_t(c + 1), 0.0) / 512);
    const core::ParticleSet& p = run.grains();
    std::vector<int> order(std::size_t(p.owned));
    for (int g = 0; g < p.owned; ++g) order[std::size_t(p.id[std::size_t(g)])] = g;
    for (const int g : order)
        for (std::size_t a = 0; a < 3; ++a) {
            state.velocity.push_back(p.velocity[a][std::size_t(g)]);
            state.place.push_back(p.position[a][std::size_t(g)]);
        }
    return state;
}

/// Root mean square; places may have passed through a side.
double distance(const std::vector<double>& a, const std::vector<double>& b, double period = 0.0)
{
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        const double d = period > 0 ? std::remainder(a[n] - b[n], period) : a[n] - b[n];
        sum += d * d;
    }
    return std::sqrt(sum / double(a.size()));
}

} // namespace

TEST_CASE("fluid and free grains are second order in time in every mode")
{
    constexpr std::array parts{64, 32, 16, 8};
    for (const io::CouplingMode mode : every_mode) {
        const State exact = end_of(mode, 1);
        std::vector<std::array<double, 4>> errors;
        for (const int n : parts) {
            const State found = end_of(mode, n);
            errors.push_back({distance(found.momentum, exact.momentum), distance(found.velocity, exact.velocity),
                              distance(found.place, exact.place, 8e-3), distance(found.fluid, exact.fluid)});
        }
        std::printf("%-10s", std::string(io::coupling_mode_words[std::size_t(mode)]).c_str());
        for (std::size_t what = 0; what < 4; ++what) {
            for (std::size_t n = 0; n < parts.size(); ++n) std::printf(" %.1e", errors[n][what]);
            const double order = std::log2(errors[2][what] / errors[3][what]);
            std::printf("  order %.2f;", order);
            CHECK(order > (what < 3 ? 1.8 : 0.9));
            if (what < 3) CHECK(order < 2.2);
        }
        std::printf("\n");
        CHECK(errors[3][3] < 2e-6); // [m/s], where the drive alone makes 0.03 m/s: the first-order part is small
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=600 long
// Error against processor time of the advection schemes, on vortices that a stream carries along: what the scenes' default rests on.
#include "tests/support/fluid_run.hpp"
#include <algorithm>
#include <ctime>
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::AdvectionScheme;

constexpr double side = 2 * std::numbers::pi, duration = 2;
const Vec3 stream(1, 0.5, 0.25);

/// A flow that is known for all times.
struct Flow {
    std::string name;
    double viscosity;
    int dimensions;  ///< that need cells
    double waviness; ///< of the grid
};

/// Plane vortices, or those whose vorticity is their velocity: both keep their shape.
Vec3 vortices(const Flow& flow, const Vec3& x)
{
    if (flow.dimensions == 2) return {-std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()), 0};
    return {std::sin(x.z()) + 0.7 * std::cos(x.y()), 0.5 * std::sin(x.x()) + std::cos(x.z()),
            0.7 * std::sin(x.y()) + 0.5 * std::cos(x.x())};
}

Vec3 velocity(const Flow& flow, const Vec3& x, double time)
{
    const double decay = flow.viscosity * (flow.dimensions == 2 ? 2 : 1);
    const Vec3 carried = flow.dimensions == 2 ? Vec3(stream.x(), stream.y(), 0) : stream;
    return carried + std::exp(-decay * time) * vortices(flow, x - time * carried);
}

struct Cost {
    double error, seconds;
    int steps;
};

/// @param share  Of the longest step that the scheme bears.
Cost cost_once(const Flow& flow, AdvectionScheme scheme, int n, double share)
{
    physics::FluidParameters water;
    water.density = 1;
    water.viscosity = flow.viscosity;
    water.advection = scheme;
    const core::Box box{{0, 0, 0}, {side, side, side}, {n, n, flow.dimensions == 2 ? 1 : n}, {2, 2, 1}, {true, true, true}};
    const double third = flow.dimensions == 2 ? 0 : 1;
    test::FluidRun run(core::make_box(box, [&](const Vec3& x) { return test::wavy(x, flow.waviness, third); }), water);
    run.start([&](const Vec3& x) { return velocity(flow, x, 0); });
    physics::TransportRates rates;
    for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b)
        rates.widen(physics::transport_rates(run.mesh().geometry(b), run.fluid().state().velocity.on(b)));
    rates.outflow = run.outflow_rate();
    const auto limit = run.fluid().by_finite_volumes() ? physics::outflow_step_limit(rates, {}) : physics::time_step_limit(rates, {});
    const int steps = int(std::ceil(duration / (share * limit.dt)));
    const std::clock_t start = std::clock();
    for (int s = 0; s < steps; ++s) run.step(duration / steps);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    return {run.velocity_error([&](const Vec3& x) { return velocity(flow, x, run.time()); }), seconds, steps};
}

/// The fastest of three.
Cost cost(const Flow& flow, AdvectionScheme scheme, int n, double share)
{
    Cost least = cost_once(flow, scheme, n, share);
    for (int repeat = 0; repeat < 2; ++repeat) least.seconds = std::min(least.seconds, cost_once(flow, scheme, n, share).seconds);
    return least;
}

} // namespace

TEST_CASE("every scheme carries vortices along a stream to second order, at the cost that is printed")
{
    const std::array flows{Flow{"plane vortices, viscosity 0.01", 0.01, 2, 0}, Flow{"the same on a wavy grid", 0.01, 2, 0.25},
                           Flow{"without viscosity", 0, 2, 0}, Flow{"vortices in space, viscosity 0.01", 0.01, 3, 0},
                           Flow{"the same on a wavy grid", 0.01, 3, 0.2}};
    for (const Flow& flow : flows) {
        const int finest = flow.dimensions == 2 ? 64 : 32;
        for (const auto& [scheme, name] : {std::pair{AdvectionScheme::lcsi, std::string("lcsi")},
                                           {AdvectionScheme::lcsi_spline, "lcsi_spline"},
                                           {AdvectionScheme::finite_volume, "finite_volume"}})
            for (const double share : {0.9, 0.45}) {
                const Cost coarse = cost(flow, scheme, finest / 2, share), fine = cost(flow, scheme, finest, share);
                for (const auto& [n, c] : {std::pair{finest / 2, coarse}, {finest, fine}})
                    MESSAGE(flow.name, " | ", name, " | ", n, " | ", c.steps, " | ", c.error, " | ", c.seconds);
                if (scheme != AdvectionScheme::lcsi_spline) CHECK(std::log2(coarse.error / fine.error) > 1.7);
            }
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A flow without viscosity that the grid cannot resolve does not gain energy without end (NUMERICS D 22).
#include "tests/support/fluid_run.hpp"
#include "tests/support/joined_boxes.hpp"
#include <doctest/doctest.h>

namespace {

core::MultiBlock box()
{
    const double length = 2 * std::numbers::pi;
    return core::make_box({{0, 0, 0}, {length, length, length}, {16, 16, 16}, {2, 1, 1}, {true, true, true}},
                          [](const core::Vec3& x) { return x; });
}

/// Largest kinetic energy over that of the start, of vortices on some 16^3 cells until they have turned some ten times.
/// @param cells  Crossed in a step; with finite volumes, the share of a cell that leaves it.
double energy_gained(core::MultiBlock grid, double cells, physics::AdvectionScheme scheme)
{
    physics::FluidParameters inviscid;
    inviscid.viscosity = 0;
    inviscid.advection = scheme;
    test::FluidRun run(std::move(grid), inviscid);
    run.start([](const core::Vec3& x) {
        return core::Vec3(std::sin(x.x()) * std::cos(x.y()) * std::cos(x.z()), -std::cos(x.x()) * std::sin(x.y()) * std::cos(x.z()),
                          0.1 * std::sin(3 * x.y()));
    });
    const auto energy = [&] {
        return run.mean([&](core::LocalBlock b, int i, int j, int k) { return 0.5 * run.velocity(b, i, j, k).squaredNorm(); });
    };
    const double start = energy();
    double most = 0;
    while (run.time() < 16) {
        physics::TransportRates rates;
        for (core::LocalBlock b = 0; b < run.mesh().own_count(); ++b)
            rates.widen(physics::transport_rates(run.mesh().geometry(b), run.fluid().state().velocity.on(b)));
        double dt = physics::time_step_limit(rates, {.largest = 0.1, .displacement = cells}).dt;
        if (run.fluid().by_finite_volumes()) dt = std::min(0.1, cells / run.outflow_rate());
        run.step(dt);
        most = std::max(most, energy());
        REQUIRE(most < 10 * start); // a flow that carries itself by the velocities of cells is here after four turns
    }
    MESSAGE("most ", most / start, ", in the end ", energy() / start);
    return most / start;
}

} // namespace

TEST_CASE("vortices that break up below the grid keep their energy within a quarter")
{
    // Semi-Lagrangian advection does not conserve energy; what it makes while vortices break up it loses again later.
    CHECK(energy_gained(box(), 0.5, physics::AdvectionScheme::lcsi) < 1.25);
    CHECK(energy_gained(box(), 0.1, physics::AdvectionScheme::lcsi) < 1.25);
}

TEST_CASE("finite volumes give such vortices no energy at all")
{
    CHECK(energy_gained(box(), 1.0, physics::AdvectionScheme::finite_volume) < 1.001);
    CHECK(energy_gained(box(), 0.1, physics::AdvectionScheme::finite_volume) < 1.001);
}

TEST_CASE("nor through sides whose points do not match")
{
    const auto halves = [] { return test::wavy_halves({{8, 16, 16}, {8, 12, 24}}, 0.0, 0); };
    CHECK(energy_gained(halves(), 0.9, physics::AdvectionScheme::finite_volume) < 1.001);
    CHECK(energy_gained(halves(), 0.2, physics::AdvectionScheme::finite_volume) < 1.001);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Ten thousand steps without viscosity (NUMERICS D 21, D 22): no scheme makes energy of nothing.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
constexpr double turn = 2 * std::numbers::pi;

/// Largest kinetic energy of plane vortices in any of ten thousand steps, over that of the start.
double most_energy(physics::AdvectionScheme scheme, double dt)
{
    physics::FluidParameters inviscid;
    inviscid.density = 1;
    inviscid.viscosity = 0;
    inviscid.advection = scheme;
    const core::Box box{{0, 0, 0}, {turn, turn, turn / 16}, {16, 16, 1}, {1, 1, 1}, {true, true, true}};
    test::FluidRun run(core::make_box(box, [](const Vec3& x) { return test::wavy(x, 0.1, 0); }), inviscid);
    run.start([](const Vec3& x) { return Vec3(-std::cos(x.x()) * std::sin(x.y()), std::sin(x.x()) * std::cos(x.y()), 0); });
    const auto energy = [&] {
        return run.mean([&](core::LocalBlock b, int i, int j, int k) { return 0.5 * run.velocity(b, i, j, k).squaredNorm(); });
    };
    const double start = energy();
    double most = 0;
    for (int s = 0; s < 10000; ++s) {
        run.step(dt);
        most = std::max(most, energy());
    }
    MESSAGE("most energy ", most / start, ", at the end ", energy() / start, " after ", run.time() / turn, " turns");
    return most / start;
}

} // namespace

TEST_CASE("vortices without viscosity have no more energy in any of 1e4 steps than at the start")
{
    // Half a cell in a step, and a twentieth.
    CHECK(most_energy(physics::AdvectionScheme::lcsi, 0.2) <= 1);
    CHECK(most_energy(physics::AdvectionScheme::lcsi, 0.02) <= 1);
    CHECK(most_energy(physics::AdvectionScheme::finite_volume, 0.2) <= 1);
}

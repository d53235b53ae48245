// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/assumed_grains.hpp"
#include <array>
#include <cmath>
#include <doctest/doctest.h>

using core::Vec3;

namespace {

constexpr double sub_step = 1e-5; // [s]

/// A grain of 2 mm that water of 0.3 m/s and its weight move; drag in units of 8.4e-6 kg / 4 ms, the seed's.
struct OneGrain {
    explicit OneGrain(double drag, double step = sub_step)
    {
        core::Sphere sphere;
        sphere.radius = 1e-3;
        sphere.density = 2000;
        grains.add(sphere);
        wet = physics::add_wet_columns(grains);
        hold = grains.add_column();
        grains.velocity[0][0] = 0.1;
        physics::WetLoad load;
        load.force = {1e-5, -4e-5, 2e-5};
        load.fluid_velocity = {0.3, 0.0, -0.1};
        load.drag = drag;
        load.added_mass = 2e-6;
        load.fluid_spin = {5.0, 0.0, 0.0};
        load.spin_drag = drag * 1e-6;
        physics::set_wet_load(grains, wet, 0, load, step);
    }
    [[nodiscard]] double& column(int n) { return grains.columns[std::size_t(n)][0]; }

    core::ParticleSet grains;
    physics::WetColumns wet{};
    int hold = 0;
};

} // namespace

TEST_CASE("loads stretched to longer sub-steps are those set for longer sub-steps")
{
    for (const double drag : {0.0, 2e-3, 2.0}) {
        OneGrain stretched(drag), longer(drag, 3 * sub_step);
        physics::stretch_loads(stretched.grains, stretched.wet, 3.0);
        for (int n = stretched.wet.keep; n < stretched.wet.impulse; ++n) {
            // Rounding, which the logarithm of what is kept magnifies where almost all is kept.
            CHECK(std::abs(stretched.column(n) - longer.column(n)) <= 1e-10 * std::abs(longer.column(n)));
        }
    }
}

TEST_CASE("drag so stiff that a sub-step keeps nothing is stretched to the velocity it leads to")
{
    OneGrain grain(1e4);
    const double drift = grain.column(grain.wet.drift);
    physics::stretch_loads(grain.grains, grain.wet, 3.0);
    CHECK(grain.column(grain.wet.keep) == 0.0);
    CHECK(grain.column(grain.wet.drift) == drift);
}

TEST_CASE("a grain that nothing holds flies as in its sub-steps; one that is held stays, and contacts bear its load")
{
    constexpr int sub_steps = 40;
    for (const double drag : {0.0, 2e-3, 2.0}) {
        OneGrain stepped(drag), free(drag), held(drag), half(drag);
        for (int n = 0; n < sub_steps; ++n)
            for (int a = 0; a < 3; ++a) {
                double& v = stepped.grains.velocity[std::size_t(a)][0];
                v = stepped.column(stepped.wet.keep) * v + stepped.column(stepped.wet.drift + a);
            }
        held.column(held.hold) = 1.0;
        half.column(half.hold) = 0.5;
        for (OneGrain* g : {&free, &held, &half}) physics::fly(g->grains, g->wet, g->hold, sub_steps * sub_step, sub_steps);
        const Vec3 load = Vec3(1e-5, -4e-5, 2e-5) + drag * Vec3(0.2, 0.0, -0.1), before(0.1, 0, 0); // F + K (u - v)
        for (int a = 0; a < 3; ++a) {
            const double moved = stepped.grains.velocity_of(0)[a] - before[a], scale = std::abs(moved) + 1e-4;
            CHECK(std::abs(free.grains.velocity_of(0)[a] - before[a] - moved) < 1e-9 * scale); // rounding, as above
            CHECK(free.column(free.wet.impulse + a) == 0.0);
            CHECK(held.grains.velocity_of(0)[a] == before[a]);
            CHECK(std::abs(held.column(held.wet.impulse + a) + sub_steps * sub_step * load[a]) < 1e-9 * sub_steps * sub_step * load.norm());
            CHECK(std::abs(half.grains.velocity_of(0)[a] - before[a] - 0.5 * moved) < 1e-9 * scale);
        }
    }
}

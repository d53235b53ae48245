// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=300
// Scalars in a flow that is being computed: what enters is in the cells, values stay in their range although the fluxes are free of
// divergence only to the tolerance of the solver, and bits depend on neither ranks nor executors.
#include "tests/support/fluid_run.hpp"
#include <doctest/doctest.h>

namespace {

using core::Vec3;
using physics::BoundaryKind;

constexpr double height = 0.02, length = 0.06, speed = 0.03;

/// A channel with a lid that shears the flow; dye and salt enter at its low end.
std::unique_ptr<test::FluidRun> channel_run(const tasks::ExecutorOptions& executor, const core::Communicator& ranks, double diffusivity)
{
    physics::FluidParameters p;
    p.viscosity = 1e-5;
    p.tolerances.pressure = 1e-5; // loose: bounds must not depend on it
    p.boundaries["x_low"] = {.kind = BoundaryKind::inflow, .velocity = {speed, 0, 0}};
    p.boundaries["x_high"] = {.kind = BoundaryKind::outflow};
    p.boundaries["y_high"] = {.velocity = {2 * speed, 0, 0}};
    const core::Box box{{0, 0, 0}, {length, height, height / 4}, {24, 12, 2}, {2, 2, 1}, {false, false, true}};
    const auto bend = [](const Vec3& x) {
        return Vec3(x + 0.1 * height * std::sin(100 * x.x()) * Vec3(0, x.y() * (height - x.y()) * 4 / (height * height), 0));
    };
    const std::vector<physics::ScalarParameters> scalars{{"dye", diffusivity, 0.25, {{"x_low", 1.0}}},
                                                         {"salt", 0.0, 3.0, {{"x_low", 3.0}}}};
    auto run = std::make_unique<test::FluidRun>(core::make_box(box, bend), p, executor, ranks, test::Carried{.scalars = scalars});
    run->start([](const Vec3&) { return Vec3(speed, 0, 0); });
    return run;
}

double amount(test::FluidRun& run, std::size_t scalar)
{
    auto& fields = run.scalars().fields();
    return run.mean([&](core::LocalBlock b, int i, int j, int k) {
        return fields.share.on(b)(i, j, k) * fields.values[scalar].on(b)(i, j, k);
    }) * run.mesh().total_volume();
}

} // namespace

TEST_CASE("what enters is there, nothing leaves its range, and what is uniform stays so")
{
    const auto run = channel_run({.kind = "serial"}, core::Communicator::world(), 0.0);
    const double before = amount(*run, 0), flow = speed * height * height / 4, dt = 0.02;
    for (int n = 1; n <= 20; ++n) { // the fastest dye comes to four fifths of the length
        run->step(dt);
        CHECK(std::abs(amount(*run, 0) - (before + flow * n * dt * (1.0 - 0.25))) <
              1e-6 * before); // in and out balance to the tolerance of the pressure
    }
    const auto& dye = run->scalars().fields().values;
    const auto outside = [&](std::size_t scalar, double low, double high) {
        return run->largest([&](core::LocalBlock b, int i, int j, int k) {
            const double q = dye[scalar].on(b)(i, j, k);
            return std::max({low - q, q - high, 0.0});
        });
    };
    CHECK(outside(0, 0.25, 1.0) < 1e-13); // round-off
    CHECK(outside(1, 3.0, 3.0) < 1e-13);
}

TEST_CASE("two ranks and one have the same bits of scalars, whoever executes")
{
    const auto alone = channel_run({.kind = "serial"}, core::Communicator::self(), 2e-5);
    for (int n = 0; n < 4; ++n) alone->step(0.04);
    for (const char* kind : {"serial", "shuffle:3", "tbb", "openmp"}) {
        const auto together = channel_run({.kind = kind, .threads = 2}, core::Communicator::world(), 2e-5);
        for (int n = 0; n < 4; ++n) together->step(0.04);
        int differences = 0;
        for (std::size_t scalar = 0; scalar < 2; ++scalar)
            for (core::LocalBlock b = 0; b < together->mesh().own_count(); ++b) {
                const auto mine = together->scalars().fields().values[scalar].on(b);
                const auto whole = alone->scalars().fields().values[scalar].on(alone->mesh().local(together->mesh().global(b)));
                core::for_each_cell(mine.extents(), [&](int i, int j, int k) { differences += mine(i, j, k) != whole(i, j, k); });
            }
        CHECK_MESSAGE(differences == 0, kind);
    }
}

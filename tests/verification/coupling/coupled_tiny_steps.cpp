// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// Going on with steps of some 1e-9 s after normal ones changes nothing and shakes no pressure, with grains (NUMERICS D33).
#include "io/run/state_file.hpp"
#include "tests/support/coupled_run.hpp"
#include "tests/support/shared_folder.hpp"
#include <cstdio>
#include <doctest/doctest.h>

using namespace test;

namespace {

struct Snapshot {
    std::vector<Vec3> velocity, grains;
    std::vector<double> pressure;
    double rough = 0.0; ///< root mean square of (p_{i-1} - 2 p_i + p_{i+1}) / 4
};

Snapshot snapshot(CoupledRun& run)
{
    Snapshot s;
    double sum = 0, count = 0;
    const auto& state = run.world().fluid()->state();
    const auto u = state.velocity.on(0);
    const auto p = state.pressure.on(0);
    const core::Extents n = p.extents();
    core::for_each_cell(n, [&](int i, int j, int k) {
        s.velocity.push_back({u.x(i, j, k), u.y(i, j, k), u.z(i, j, k)});
        s.pressure.push_back(p(i, j, k));
        const auto add = [&](double low, double high) {
            sum += std::pow(0.25 * (low - 2 * p(i, j, k) + high), 2);
            ++count;
        };
        if (i > 0 && i + 1 < n.ni) add(p(i - 1, j, k), p(i + 1, j, k));
        if (j > 0 && j + 1 < n.nj) add(p(i, j - 1, k), p(i, j + 1, k));
        if (k > 0 && k + 1 < n.nk) add(p(i, j, k - 1), p(i, j, k + 1));
    });
    s.rough = std::sqrt(sum / count);
    s.grains.resize(std::size_t(run.grains().owned));
    for (int g = 0; g < run.grains().owned; ++g) s.grains[std::size_t(run.grains().id[std::size_t(g)])] = run.grains().velocity_of(g);
    return s;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    double most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, (a[n] - b[n]).norm());
    return most;
}

double largest(const std::vector<double>& a)
{
    double most = 0;
    for (const double x : a) most = std::max(most, std::abs(x));
    return most;
}

} // namespace

TEST_CASE("going on with steps of 1e-9 s changes nothing and shakes no pressure")
{
    struct Case {
        const char* name;
        Vec3 size;
        std::array<int, 3> cells;
        int count;
    };
    for (const Case& c :
         {Case{"one dimension", {6e-3, 24e-3, 6e-3}, {1, 12, 1}, 45}, Case{"two dimensions", {16e-3, 24e-3, 6e-3}, {8, 12, 1}, 100},
          Case{"three dimensions", {16e-3, 24e-3, 16e-3}, {8, 12, 8}, 250}}) {
        CoupledBox box;
        box.size = c.size;
        box.cells = c.cells;
        box.gravity = {0, -9.81, 0};
        box.periodic = {io::Axis::x, io::Axis::z};
        box.filter = 1.0;
        CoupledRun run(box, c.count);
        run.start();
        for (int n = 0; n < 40; ++n) run.step();
        const Snapshot before = snapshot(run);
        run.step();
        const Snapshot last = snapshot(run);
        const support::SharedFolder folder(core::Communicator::self());
        const auto path = io::save_state(run.world(), folder.path(), 1);
        io::Scene slow = scene_of(box, c.count);
        slow.contact->steps_per_contact = 1000000; // sub-steps of the grains of about 1e-9 s
        slow.run.time_step = 1e-9;
        CoupledRun again(slow);
        io::load_state(io::CheckpointReader(path, core::Communicator::self()), again.world());
        again.go_on();
        for (int n = 0; n < 50; ++n) again.step();
        const Snapshot now = snapshot(again);
        const double time = again.world().time() - run.world().time(), moved = largest_difference(now.velocity, last.velocity);
        const double acceleration = largest_difference(last.velocity, before.velocity) / box.dt;
        std::printf("%-16s: 50 steps of %.1e s: fluid %.1e (%.1e at its last acceleration), grains %.1e m/s\n", c.name,
                    again.world().clock().dt, moved, acceleration * time, largest_difference(now.grains, last.grains));
        std::printf("    pressure %.3g -> %.3g, roughness %.3g -> %.3g Pa\n", largest(last.pressure), largest(now.pressure), last.rough,
                    now.rough);
        // Forces of contacts are those of the moment, no longer the mean over a millisecond: at 0.1 m/s grains overlap by
        // 0.1 m/s sqrt(m / stiffness) = 9 um and are accelerated by 1,100 m/s2; through their added mass the fluid feels it.
        CHECK(largest_difference(now.grains, last.grains) < 2000 * time);
        CHECK(moved < 100 * time);
        CHECK(largest(now.pressure) < 10 * largest(last.pressure));
        CHECK(now.rough < 0.15 * largest(now.pressure)); // a checkerboard is as rough as it is high
        const auto later = io::save_state(again.world(), folder.path(), 1);
        CoupledRun after(box, c.count);
        io::load_state(io::CheckpointReader(later, core::Communicator::self()), after.world());
        after.go_on();
        for (int n = 0; n < 3; ++n) after.step();
        CHECK(largest(snapshot(after).pressure) < 2 * largest(last.pressure));
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What a running world writes: momentum that closes, numbers and files that do not depend on the ranks.
// ctest: ranks=2 timeout=300
#include "core/base/team.hpp"
#include "io/files/exact_sums.hpp"
#include "io/run/gathered_particles.hpp"
#include "io/run/interval_clock.hpp"
#include "io/run/world_metrics.hpp"
#include "io/run/world_pictures.hpp"
#include "io/run/world_results.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/support/shared_folder.hpp"
#include <cmath>
#include <doctest/doctest.h>

namespace {

io::Scene small_bed(bool with_lift)
{
    const std::string text = R"(name: small bed
grid:
  box: { size: [8 mm, 12 mm, 8 mm], cells: [4, 6, 4], blocks: [1, 2, 1] }
  periodic: [x, z]
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  drive: { pressure_gradient: 500 Pa/m, axis: x }
gravity: { direction: -y }
particles:
  - { name: glass, count: 20, diameter: 2 mm, density: 2500 kg/m3 }
  - { name: light, count: 10, diameter: 1.5 mm, density: 1100 kg/m3 }
contact: { law: linear, stiffness: 200 N/m, restitution: 0.9, friction: 0.3, walls: primitive }
coupling: { lift: )" + std::string(with_lift ? "on" : "off") +
                             " }\nrun: { until: 1 s, time_step: 1 ms }\n";
    return test::scene_from_text(text);
}

/// Rows of metrics after each of some steps; checks the books of momentum on the way.
std::vector<std::vector<double>> rows_of(const core::Communicator& ranks, const std::string& file, bool with_lift)
{
    io::World world(small_bed(with_lift), ranks);
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    io::WorldMetrics metrics(world, file);
    std::vector<std::vector<double>> rows{metrics.row()};
    double pushed = 0;
    for (int step = 0; step < 12; ++step) {
        world.step(*executor);
        metrics.after_step();
        const io::MomentumLedger& ledger = *metrics.ledger();
        // Rounding: sums of a few hundred cells and grains, relative to their largest term.
        CHECK(ledger.defect() < 1e-12);
        CHECK(ledger.exchange_defect() < 1e-12);
        pushed += ledger.impulses().drive.x();
        rows.push_back(metrics.row());
    }
    // gradient * volume * time; the time is a sum of twelve rounded steps
    CHECK(pushed == test::relative(500 * 8e-3 * 12e-3 * 8e-3 * world.time()).epsilon(1e-12));
    return rows;
}

} // namespace

TEST_CASE("what the fluid gives the grains get or are owed, and all change of momentum is explained")
{
    const auto self = core::Communicator::self(), world = core::Communicator::world();
    const support::SharedFolder shared(world);
    const std::string own = shared.path() + "/" + std::to_string(world.rank());
    (void)rows_of(self, own + "_lift.csv", true);
    CHECK(rows_of(self, own + ".csv", false) == rows_of(world, shared.path() + "/all.csv", false));
}

TEST_CASE("sums over particles have the same bits for any order and any share")
{
    const auto world = core::Communicator::world(), self = core::Communicator::self();
    std::vector<double> all;
    for (int n = 0; n < 1000; ++n) all.push_back(std::sin(7.0 * n) * std::pow(10.0, n % 17 - 8));
    std::vector<double> mine;
    for (std::size_t n = all.size(); n-- > 0;)
        if (int(n) % world.size() == world.rank()) mine.push_back(all[n]);
    const double sum = io::exact_sums(world, {mine})[0];
    CHECK(sum == io::exact_sums(self, {all})[0]);
    long double reference = 0;
    for (const double x : all) reference += x;
    CHECK(std::abs(sum - double(reference)) < 1e-7); // 1000 additions of 1e8 in extended precision
    CHECK(io::exact_sums(world, {{}})[0] == 0.0);
}

TEST_CASE("a restart goes on with the numbers of its outputs, and wall time is that of rank 0")
{
    const auto ranks = core::Communicator::world();
    const io::Interval every{io::Interval::Clock::simulated, 0.1};
    io::IntervalClock through(every, ranks), restarted(every, ranks);
    std::vector<std::int64_t> numbers, continued;
    double time = 0;
    for (int step = 0; step <= 60; ++step, time += 0.01) {
        if (through.due({time, step, 0})) numbers.push_back(through.number());
        if (step == 25) restarted.resume({time, step, 0});
        if (step > 25 && restarted.due({time, step, 0})) continued.push_back(restarted.number());
    }
    CHECK(numbers == std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6});
    CHECK(continued == std::vector<std::int64_t>{3, 4, 5, 6});
    io::IntervalClock wall({io::Interval::Clock::wall, 10.0}, ranks);
    CHECK_FALSE(wall.due({0, 1, ranks.rank() == 0 ? 9.0 : 50.0}));
    CHECK(wall.due({0, 2, ranks.rank() == 0 ? 11.0 : 0.0}));
    CHECK_FALSE(io::IntervalClock({}, ranks).due({5.0, 5, 5.0}));
}

TEST_CASE("pictures and results show every particle once, in the order of their ids")
{
    const auto ranks = core::Communicator::world();
    const support::SharedFolder shared(ranks);
    io::World world(small_bed(false), ranks);
    world.compile();
    const auto all = io::gather_particles(*world.grains(), ranks);
    CHECK(all.size() == (ranks.rank() == 0 ? 30 : 0));
    for (std::size_t n = 1; n < all.size(); ++n) CHECK(all[n - 1].id < all[n].id);
    for (const auto& p : all) CHECK(p.radius == (p.species == 0 ? 1e-3 : 0.75e-3));

    io::WorldResults results(world, shared.path() + "/results");
    results.write(world, 7);
    io::PictureStyle style{320, 180, io::PictureStyle::Slice::speed};
    io::WorldPictures pictures(world, shared.path() + "/frames", style);
    pictures.draw(world, 7);
    pictures.finish();
    const bool drawn = std::filesystem::exists(shared.path() + "/frames/frame_000007.png");
    if (ranks.rank() == 0) CHECK(drawn == pictures.take_warning().empty()); // a machine without EGL has a warning instead
    ranks.barrier();
    for (const char* name : {"fluid_000007.hdf", "particles_000007.hdf", "grid.h5"})
        CHECK(std::filesystem::exists(shared.path() + "/results/" + name));
}

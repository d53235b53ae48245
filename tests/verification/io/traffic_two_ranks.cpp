// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Grains that rain in at the top and leave at the bottom: the same bits on any number of ranks and through a restart, all accounted for.
// ctest: ranks=2 timeout=120
#include "core/base/error.hpp"
#include "io/run/gathered_particles.hpp"
#include "io/run/momentum_ledger.hpp"
#include "io/run/state_file.hpp"
#include "io/run/world_metrics.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/support/shared_folder.hpp"
#include <cstring>
#include <doctest/doctest.h>

namespace {

io::Scene shower()
{
    return test::scene_from_text(R"(name: shower
grid:
  box: { size: [16 mm, 30 mm, 8 mm], cells: [4, 6, 2], blocks: [2, 2, 1] }
  periodic: [z]
gravity: { direction: -y }
particles:
  - { name: bed, count: 40, diameter: 2 mm, density: 2500 kg/m3, initial: { high: [15 mm, 20 mm, 8 mm] } }
  - name: rain
    count: 0
    sizes: { share_of: number, list: [[1 mm, 3], [2 mm, 1]] }
    density: 2500 kg/m3
    inflow: { rate: 3000 Hz, low: [2 mm, 25 mm, 0 mm], high: [14 mm, 28 mm, 8 mm], velocity: [0.1 m/s, -0.5 m/s, 0 m/s] }
outlets:
  - { name: left, low: [0 mm, 0 mm, 0 mm], high: [5 mm, 3 mm, 8 mm] }
  - { name: right, cylinder: { from: [16 mm, 0 mm, 4 mm], to: [16 mm, 4 mm, 4 mm], radius: 5 mm } }
contact: { stiffness: 500 N/m, restitution: 0.8, friction: 0.3, walls: primitive }
run: { until: 1 s }
)");
}

io::Scene shower_in_water()
{
    return test::scene_from_text(R"(name: shower under water
grid:
  box: { size: [16 mm, 32 mm, 8 mm], cells: [4, 8, 2], blocks: [2, 2, 1] }
  periodic: [z]
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  boundaries:
    - { at: y_low, kind: inflow, velocity: [0 m/s, 0.02 m/s, 0 m/s] }
    - { at: y_high, kind: outflow }
  scalars: [ { name: dye, initial: 0.7, diffusivity: 1e-6 m2/s, entering: [ { at: y_low, value: 0.7 } ] } ]
gravity: { direction: -y }
particles:
  - name: rain
    count: 0
    sizes: { share_of: number, list: [[1 mm, 3], [2 mm, 1]] }
    density: 2500 kg/m3
    inflow: { rate: 400 Hz, low: [2 mm, 24 mm, 0 mm], high: [14 mm, 29 mm, 8 mm], velocity: [0.1 m/s, -0.1 m/s, 0 m/s] }
outlets:
  - { name: floor, low: [0 mm, 0 mm, 0 mm], high: [16 mm, 3 mm, 8 mm] }
contact: { stiffness: 500 N/m, restitution: 0.8, friction: 0.3, walls: primitive }
run: { until: 1 s, time_step: 4 ms }
)");
}

/// Ids and places of all grains, on rank 0.
std::vector<std::byte> grains_of(const io::World& world)
{
    const auto all = io::gather_particles(*world.grains(), world.ranks());
    std::vector<std::byte> bytes(all.size() * sizeof(io::GatheredParticle));
    if (!all.empty()) std::memcpy(bytes.data(), all.data(), bytes.size());
    return bytes;
}

struct End {
    std::vector<std::byte> grains;
    std::vector<double> row;
};

/// What is watched of a world while it steps.
struct Nothing {
    explicit Nothing(io::World& /*world*/) {}
    void after_step() {}
};

/// The books of momentum: nothing may be left, whoever comes and goes.
struct Books {
    explicit Books(io::World& world) : ledger(world) {}
    void after_step()
    {
        ledger.update();
        CHECK(ledger.defect() < 1e-9);           // what the solver of the viscosity leaves
        CHECK(ledger.exchange_defect() < 1e-12); // rounding
    }
    io::MomentumLedger ledger;
};

struct Course {
    io::Scene scene;
    int steps;
    int stop;          ///< after which a new world goes on from a checkpoint; none for 0
    double last = 0.0; ///< time at which grains last came and went [s]
};

template <class Watch>
std::unique_ptr<io::World> run(Course& course, const core::Communicator& ranks, const std::string& folder)
{
    std::filesystem::create_directories(folder);
    auto world = std::make_unique<io::World>(course.scene, ranks);
    auto executor = tasks::make_executor({"serial"}, world->compile());
    auto watch = std::make_unique<Watch>(*world);
    for (int step = 1; step <= course.steps; ++step) {
        course.last = world->time();
        world->step(*executor);
        watch->after_step();
        if (step != course.stop) continue;
        const std::string checkpoint = io::save_state(*world, folder, 1);
        watch.reset();
        world = std::make_unique<io::World>(course.scene, ranks);
        io::load_state(io::CheckpointReader(checkpoint, ranks), *world);
        executor = tasks::make_executor({"serial"}, world->compile());
        watch = std::make_unique<Watch>(*world);
    }
    return world;
}

/// The same in three ways: on each rank by itself, on all together, and with a restart in the middle. @param check(world, course)  of each.
template <class Watch, class Check>
void compare(const io::Scene& scene, int steps, Check check)
{
    const auto world = core::Communicator::world(), self = core::Communicator::self();
    const support::SharedFolder shared(world);
    const auto end_of = [&](const core::Communicator& ranks, const std::string& name, int stop) {
        Course course{scene, steps, stop};
        const std::string folder = shared.path() + "/" + name;
        const auto end = run<Watch>(course, ranks, folder);
        check(*end, course);
        const io::WorldMetrics metrics(*end, folder + "/metrics.csv");
        return End{grains_of(*end), metrics.row()};
    };
    const End alone = end_of(self, std::to_string(world.rank()), 0), together = end_of(world, "all", 0);
    const End restarted = end_of(world, "restarted", steps / 2);
    CHECK(alone.row == together.row);
    CHECK(alone.row == restarted.row);
    if (world.rank() == 0) CHECK(alone.grains == together.grains);
    if (world.rank() == 0) CHECK(alone.grains == restarted.grains);
}

} // namespace

TEST_CASE("grains that come and go are the same on one rank, on two and through a restart")
{
    compare<Nothing>(shower(), 120, [](const io::World& world, const Course& course) {
        const auto entered = world.traffic()->entered();
        const auto taken = world.traffic()->taken_away();
        REQUIRE(entered.size() == 1);
        REQUIRE(taken.size() == 2);
        CHECK(entered[0].count == std::int64_t(3000 * course.last)); // there is always room
        CHECK(taken[0].count > 0);
        CHECK(taken[1].count > 0);
        double here = world.grains()->particles.owned;
        world.ranks().sum(std::span(&here, 1));
        CHECK(here == 40 + entered[0].count - taken[0].count - taken[1].count);
    });
}

TEST_CASE("so they are in water, whose dye keeps its concentration when a grain takes the place of water")
{
    compare<Books>(shower_in_water(), 90, [](const io::World& world, const Course&) {
        CHECK(world.traffic()->entered()[0].count > 60);
        CHECK(world.traffic()->taken_away()[0].count > 5);
        for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
            core::for_each_cell(world.mesh().geometry(b).cells, [&](int i, int j, int k) {
                CHECK(std::abs(world.scalars()->fields().values[0].on(b)(i, j, k) - 0.7) < 1e-6); // tolerance of the pressure
            });
    });
}

TEST_CASE("the books notice when what comes in and goes out, by itself or with the water, is left out")
{
    io::World world(shower_in_water(), core::Communicator::self());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    io::MomentumLedger books(world);
    double without_traffic = 0, without_through = 0;
    for (int step = 0; step < 20; ++step) {
        world.step(*executor);
        books.update();
        const io::MomentumImpulses& lines = books.impulses();
        without_traffic = std::max(without_traffic, books.defect(lines.outer() - lines.traffic));
        without_through = std::max(without_through, books.defect(lines.outer() - lines.through));
    }
    CHECK(without_traffic > 1e-6);
    CHECK(without_through > 1e-6);
}

TEST_CASE("a grain that is lost or twice there is an error that names it, on all ranks")
{
    const auto ranks = core::Communicator::world();
    io::World world(shower(), ranks);
    const core::ParticleSet before = world.grains()->particles;
    core::ParticleSet& grains = world.grains()->particles;
    CHECK_NOTHROW(world.traffic()->check(grains, before, ranks));
    const auto has_7 = std::find(grains.id.begin(), grains.id.end(), 7);
    std::vector<int> stay;
    for (int i = 0; i < grains.owned; ++i)
        if (grains.id[std::size_t(i)] != 7) stay.push_back(i);
    const bool mine = has_7 != grains.id.end();
    grains.reorder(stay);
    CHECK_THROWS_WITH_AS(world.traffic()->check(grains, before, ranks),
                         "39 particles are here instead of 40; lost since the step before: 7", core::NumericsError);
    if (mine) { // the right number, but not the right one
        core::Sphere stranger;
        stranger.radius = stranger.density = 1.0;
        stranger.id = 99;
        grains.add(stranger);
    }
    CHECK_THROWS_WITH_AS(world.traffic()->check(grains, before, ranks),
                         "40 particles are here instead of 40; lost since the step before: 7; not here before: 99", core::NumericsError);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Grains that rain in at the top and leave at the bottom: the same bits on any number of ranks and through a restart, all accounted for.
// ctest: ranks=2 timeout=120
#include "core/base/error.hpp"
#include "io/run/gathered_particles.hpp"
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

constexpr int all_steps = 120;

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

/// @param stop  Step after which a new world goes on from a checkpoint; none for 0.
End run(const core::Communicator& ranks, const std::string& folder, int stop)
{
    std::filesystem::create_directories(folder);
    auto world = std::make_unique<io::World>(shower(), ranks);
    auto executor = tasks::make_executor({"serial"}, world->compile());
    for (int step = 1; step <= all_steps; ++step) {
        world->step(*executor);
        if (step != stop) continue;
        const std::string checkpoint = io::save_state(*world, folder, 1);
        world = std::make_unique<io::World>(shower(), ranks);
        io::load_state(io::CheckpointReader(checkpoint, ranks), *world);
        executor = tasks::make_executor({"serial"}, world->compile());
    }
    const io::WorldMetrics metrics(*world, folder + "/metrics.csv");
    const auto entered = world->traffic()->entered();
    const auto taken = world->traffic()->taken_away();
    REQUIRE(entered.size() == 1);
    REQUIRE(taken.size() == 2);
    CHECK(entered[0].count == std::int64_t(3000 * world->time())); // there is always room
    CHECK(taken[0].count > 0);
    CHECK(taken[1].count > 0);
    double here = world->grains()->particles.owned;
    ranks.sum(std::span(&here, 1));
    CHECK(here == 40 + entered[0].count - taken[0].count - taken[1].count);
    return {grains_of(*world), metrics.row()};
}

} // namespace

TEST_CASE("grains that come and go are the same on one rank, on two and through a restart")
{
    const auto world = core::Communicator::world(), self = core::Communicator::self();
    const support::SharedFolder shared(world);
    const std::string own = shared.path() + "/" + std::to_string(world.rank());
    const End alone = run(self, own, 0), together = run(world, shared.path() + "/all", 0);
    const End restarted = run(world, shared.path() + "/restarted", all_steps / 2);
    CHECK(alone.row == together.row);
    CHECK(alone.row == restarted.row);
    if (world.rank() == 0) CHECK(alone.grains == together.grains);
    if (world.rank() == 0) CHECK(alone.grains == restarted.grains);
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

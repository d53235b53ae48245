// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2
// Grains and fluid across sides of blocks whose points do not match have the same bits on one rank and on two.
#include "tests/support/coupled_run.hpp"
#include "tests/support/joined_scene.hpp"
#include <map>

TEST_CASE("grains that cross a side whose points do not match do so on two ranks as on one, bit for bit")
{
    const core::Communicator world = core::Communicator::world();
    const test::BoxesFile file(world, {{{0, 0, 0}, {8e-3, 16e-3, 8e-3}, {6, 12, 6}, {1, 1, 1}, {}},
                                       {{8e-3, 0, 0}, {16e-3, 16e-3, 8e-3}, {8, 15, 9}, {1, 1, 1}, {}}});
    const io::Scene scene = test::scene_from_text("name: bed across a side\n" + file.grid("x, z") + R"(fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }
  drive: { pressure_gradient: 5 kPa/m }
gravity: { direction: -y }
particles: [ { name: sand, count: 100, diameter: 1.5 mm, density: 2000 kg/m3 } ]
contact: { stiffness: 500 N/m, restitution: 0.6, friction: 0.4 }
coupling: { added_mass: on, lift: on, torque: on, mode: pipelined }
run: { until: 1 s, time_step: 1 ms }
)");
    test::CoupledRun shared(scene, "shuffle:3", world), alone(scene, "serial", core::Communicator::self());
    shared.start({0.3, 0, 0}, {0.5, 0, 0});
    alone.start({0.3, 0, 0}, {0.5, 0, 0});
    const int before = shared.grains().owned;
    int moved = 0;
    for (int n = 0; n < 25; ++n) {
        shared.step();
        alone.step();
        moved = std::max(moved, std::abs(shared.grains().owned - before));
    }
    CHECK(moved > 0);
    std::map<std::int64_t, int> row;
    for (int g = 0; g < alone.grains().owned; ++g) row[alone.grains().id[std::size_t(g)]] = g;
    int different = 0;
    for (int g = 0; g < shared.grains().owned; ++g) {
        const int other = row.at(shared.grains().id[std::size_t(g)]);
        different += (shared.grains().velocity_of(g) - alone.grains().velocity_of(other)).norm() != 0;
        different += (shared.grains().position_of(g) - alone.grains().position_of(other)).norm() != 0;
    }
    const core::Mesh &mine = shared.world().mesh(), &all = alone.world().mesh();
    REQUIRE(mine.own_count() == 1);
    const auto u = shared.world().fluid()->state().velocity.on(0),
               v = alone.world().fluid()->state().velocity.on(all.local(mine.global(0)));
    core::for_each_cell(mine.geometry(0).cells, [&](int i, int j, int k) {
        for (int c = 0; c < 3; ++c) different += u.component(c)(i, j, k) != v.component(c)(i, j, k);
    });
    CHECK(different == 0);
}

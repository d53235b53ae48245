// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2
// Grains and fluid across sides of blocks whose points do not match have the same bits on one rank and on two.
#include "tests/support/different_bits.hpp"
#include "tests/support/joined_scene.hpp"

TEST_CASE("grains that cross a side whose points do not match do so on two ranks as on one, bit for bit")
{
    const core::Communicator world = core::Communicator::world();
    const test::BoxesFile file(world, {{{0, 0, 0}, {8e-3, 16e-3, 8e-3}, {6, 12, 6}, {1, 1, 1}, {}},
                                       {{8e-3, 0, 0}, {16e-3, 16e-3, 8e-3}, {8, 15, 9}, {1, 1, 1}, {}}});
    for (const std::string advection : {"lcsi", "finite_volume"}) {
        const io::Scene scene = test::scene_from_text("name: bed across a side\n" + file.grid("x, z") + R"(fluid:
  oil: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }
  advection: )" + advection + R"(
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
        REQUIRE(shared.world().mesh().own_count() == 1);
        CHECK(test::different_bits(shared, alone) == 0);
    }
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=120
// Grains in a fluid that does not feel them: the bits are those of one rank, and those of a run that was interrupted.
#include "io/run/state_file.hpp"
#include "tests/support/different_bits.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/support/shared_folder.hpp"
#include <doctest/doctest.h>

using namespace test;

namespace {

io::Scene stream()
{
    return scene_from_text(R"(name: stream
grid: { box: { size: [32 mm, 16 mm, 16 mm], cells: [16, 8, 8], blocks: [4, 1, 1] }, periodic: [x] }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-5 m2/s }
  drive: { bulk_velocity: 0.3 m/s, over_time: { frequency: 10 Hz, mean: 1, amplitude: 0.5 } }
  turbulence: { model: k-epsilon, speed: 0.3 m/s }
gravity: { direction: -y }
particles:
  - { name: grains, count: 60, diameter: 2 mm, density: 2000 kg/m3 }
contact: { stiffness: 500 N/m }
coupling: { feedback: one_way, lift: on, history: on }
run: { until: 1 s, time_step: 1 ms }
)");
}

} // namespace

TEST_CASE("one way, grains and fluid on two ranks are those of one rank, bit for bit")
{
    CoupledRun shared(stream(), "shuffle:3"), alone(stream(), "serial", core::Communicator::self());
    shared.go_on();
    alone.go_on();
    for (int n = 0; n < 20; ++n) {
        shared.step();
        alone.step();
    }
    CHECK(shared.grains().owned < 60);
    CHECK(different_bits(shared, alone) == 0);
}

TEST_CASE("one way, a run that was interrupted goes on with the same bits")
{
    const support::SharedFolder folder(core::Communicator::world());
    CoupledRun whole(stream());
    whole.go_on();
    for (int n = 0; n < 5; ++n) whole.step();
    const std::string file = io::save_state(whole.world(), folder.path(), 1);
    CoupledRun again(stream(), "serial", core::Communicator::self());
    io::load_state(io::CheckpointReader(file, core::Communicator::self()), again.world());
    again.go_on();
    for (int n = 0; n < 5; ++n) {
        whole.step();
        again.step();
    }
    CHECK(different_bits(whole, again) == 0);
}

// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2
// Two ranks compute the same bits as one, while grains cross between them, whichever mode couples.
#include "tests/support/different_bits.hpp"
#include <doctest/doctest.h>

using namespace test;

TEST_CASE("grains and fluid on two ranks are those of one rank, bit for bit")
{
    const auto check = [](io::CouplingMode mode, io::AdvectionScheme advection) {
        CoupledBox box;
        box.blocks = {2, 2, 1};
        box.periodic = {io::Axis::x, io::Axis::z};
        box.gravity = {0, -9.81, 0};
        box.pressure_gradient = 1e4;
        box.mode = mode;
        const int count = mode == io::CouplingMode::concurrent ? 60 : 200; // more would be too dense for it
        io::Scene scene = scene_of(box, count);
        scene.fluid->advection = advection;
        CoupledRun shared(scene, "shuffle:3"), alone(scene, "serial", core::Communicator::self());
        shared.start({0.3, 0, 0}, {0.5, 0, 0});
        alone.start({0.3, 0, 0}, {0.5, 0, 0});
        for (int n = 0; n < 20; ++n) {
            shared.step();
            alone.step();
        }
        CHECK(shared.grains().owned < count);
        CHECK(shared.world().mode_reason().ends_with("as the scene asks"));
        CHECK(different_bits(shared, alone) == 0);
    };
    for (const io::CouplingMode mode : every_mode) check(mode, io::AdvectionScheme::lcsi);
    for (const io::CouplingMode mode : {io::CouplingMode::pipelined, io::CouplingMode::coarse})
        check(mode, io::AdvectionScheme::finite_volume);
}

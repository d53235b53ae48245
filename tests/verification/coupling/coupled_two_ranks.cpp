// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2
// Two ranks compute the same bits as one, while grains cross between them, whichever mode couples.
#include "tests/support/coupled_run.hpp"
#include <doctest/doctest.h>
#include <map>

using namespace test;

TEST_CASE("grains and fluid on two ranks are those of one rank, bit for bit")
{
    for (const io::CouplingMode mode : every_mode) {
        CoupledBox box;
        box.blocks = {2, 2, 1};
        box.periodic = {io::Axis::x, io::Axis::z};
        box.gravity = {0, -9.81, 0};
        box.pressure_gradient = 1e4;
        box.mode = mode;
        const int count = mode == io::CouplingMode::concurrent ? 60 : 200; // more would be too dense for it
        CoupledRun shared(scene_of(box, count), "shuffle:3"), alone(scene_of(box, count), "serial", core::Communicator::self());
        shared.start({0.3, 0, 0}, {0.5, 0, 0});
        alone.start({0.3, 0, 0}, {0.5, 0, 0});
        for (int n = 0; n < 20; ++n) {
            shared.step();
            alone.step();
        }
        std::map<std::int64_t, int> row;
        for (int g = 0; g < alone.grains().owned; ++g) row[alone.grains().id[std::size_t(g)]] = g;
        int different = 0;
        for (int g = 0; g < shared.grains().owned; ++g) {
            const int other = row.at(shared.grains().id[std::size_t(g)]);
            different += (shared.grains().velocity_of(g) - alone.grains().velocity_of(other)).norm() != 0;
            different += (shared.grains().position_of(g) - alone.grains().position_of(other)).norm() != 0;
        }
        const core::Mesh &mine = shared.world().mesh(), &all = alone.world().mesh();
        for (core::LocalBlock b = 0; b < mine.own_count(); ++b) {
            const auto u = shared.world().fluid()->state().velocity.on(b),
                       v = alone.world().fluid()->state().velocity.on(all.local(mine.global(b)));
            core::for_each_cell(mine.geometry(b).cells, [&](int i, int j, int k) {
                for (int c = 0; c < 3; ++c) different += u.component(c)(i, j, k) != v.component(c)(i, j, k);
            });
        }
        CHECK(shared.grains().owned < count);
        CHECK(shared.world().mode_reason().ends_with("as the scene asks"));
        CHECK(different == 0);
    }
}

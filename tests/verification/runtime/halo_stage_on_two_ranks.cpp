// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=60
#include "core/grid/box.hpp"
#include "tasks/exchange_filler.hpp"
#include "tasks/executor.hpp"
#include <doctest/doctest.h>

using namespace tasks;

TEST_CASE("a halo stage brings the neighbours' values, also between ranks and for two fields at once")
{
    const auto world = core::Communicator::world();
    const core::Box box{{0, 0, 0}, {1, 1, 1}, {8, 4, 4}, {4, 1, 1}, {true, true, true}};
    const core::Mesh mesh(core::make_box(box), world.rank(), world.size());
    core::ScalarField p({"p", "-", 1, false}, mesh.own_cells()), shifted({"shifted", "-", 0, false}, mesh.own_cells());
    core::VectorField u({"u", "-", 1, false}, mesh.own_cells());
    ExchangeFiller filler(mesh, world);
    StageGraph graph(Layout{std::vector<std::ptrdiff_t>(std::size_t(mesh.own_count()), 32), 1}, world);
    graph.fill_halos_with(filler);
    graph.each_block(
        "number",
        [&mesh](int b, core::View<double> pressure, core::VectorView<double> velocity) {
            core::for_each_cell(pressure.extents(), [&](int i, int j, int k) {
                pressure(i, j, k) = 2 * mesh.global(b) + i; // the number of the cell along x
                velocity.y(i, j, k) = 100 + pressure(i, j, k);
            });
        },
        writes(p, u));
    graph.each_block(
        "shift",
        [](int, core::View<const double> pressure, core::VectorView<const double> velocity, core::View<double> out) {
            core::for_each_cell(out.extents(),
                                [&](int i, int j, int k) { out(i, j, k) = pressure(i + 1, j, k) + 1000 * velocity.y(i - 1, j, k); });
        },
        reads(halo(p, 1), halo(u, 1)), writes(shifted));
    graph.sink(shifted);
    const Plan plan = graph.compile();
    for (const std::string kind : {"serial", "shuffle:2", "openmp", "tbb"}) {
        CAPTURE(kind);
        make_executor({kind, 1, nullptr}, plan)->run_step(0);
        for (int b = 0; b < mesh.own_count(); ++b)
            core::for_each_cell(shifted.on(b).extents(), [&](int i, int j, int k) {
                const int x = 2 * mesh.global(b) + i;
                CHECK(shifted.on(b)(i, j, k) == (x + 1) % 8 + 1000 * (100 + (x + 7) % 8));
            });
    }
}

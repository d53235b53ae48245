// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Result files hold the same numbers for any number of ranks.
// ctest: ranks=2 timeout=120
#include "io/files/vtkhdf.hpp"
#include "tests/support/sample_state.hpp"
#include "tests/support/shared_folder.hpp"

#include <doctest/doctest.h>

using support::State;

namespace {

void write_results(const State& state, const std::string& folder, const core::Communicator& ranks)
{
    io::FluidResults fluid(folder, ranks, state.blocks, support::nodes_of(state));
    (void)fluid.write({4, 0.5}, {io::views(state.pressure), io::views(state.velocity)});
    const io::RowOrder rows = state.order(ranks);
    const auto id = rows.apply(std::span(state.ids), 1);
    const auto position = rows.apply(std::span(state.position), 3);
    io::ParticleResults particles(folder, ranks);
    (void)particles.write({4, 0.5}, {position, {{"velocity", 3, position}}, {{"id", 1, id}}, rows.first_row(), rows.total_rows()});
}

} // namespace

TEST_CASE("results written by all ranks are those written by one")
{
    const auto world = core::Communicator::world(), self = core::Communicator::self();
    const support::SharedFolder shared(world);
    const std::string own = shared.path() + "/" + std::to_string(world.rank());
    State share = support::share_of_state(world);
    share.fill(2.0, world.rank(), world.size());
    write_results(share, shared.path(), world);
    write_results(support::whole_state(2.0), own, self);
    for (const std::string name : {"/grid.h5", "/fluid_000004.hdf", "/particles_000004.hdf"}) {
        const auto together = io::hdf5::File::open(shared.path() + name), alone = io::hdf5::File::open(own + name);
        REQUIRE(together.datasets() == alone.datasets());
        CHECK(!together.datasets().empty());
        for (const std::string& data : alone.datasets()) {
            INFO(name, " ", data);
            if (alone.integers(data)) CHECK(together.read<std::int64_t>(data) == alone.read<std::int64_t>(data));
            else CHECK(together.read<double>(data) == alone.read<double>(data));
        }
    }
}
